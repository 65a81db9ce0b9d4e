// SPDX-License-Identifier: MIT
// A table as text, CSV and JSON.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

/// Rows of named values; the first column is text, the others are numbers.
class Report {
public:
    explicit Report(std::vector<std::string> columns) : columns_(std::move(columns)) {}

    void add(std::string what, std::vector<double> values);
    /// Adds a line under the table.
    void note(std::string text) { notes_.push_back(std::move(text)); }

    void print(std::ostream& out) const;
    void write_csv(std::ostream& out) const;
    void write_json(std::ostream& out) const;

private:
    struct Row {
        std::string what;
        std::vector<double> values;  // NaN: not measured
    };
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
    std::vector<std::string> notes_;
};
