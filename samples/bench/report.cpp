// SPDX-License-Identifier: MIT
#include "report.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ostream>

namespace {

std::string number(double value) {
    if (std::isnan(value)) return "-";
    char text[32];
    std::snprintf(text, sizeof text, "%.4g", value);
    return text;
}

}  // namespace

void Report::add(std::string what, std::vector<double> values) {
    values.resize(columns_.size() - 1, std::nan(""));
    rows_.push_back({std::move(what), std::move(values)});
}

void Report::print(std::ostream& out) const {
    std::vector<std::vector<std::string>> cells{columns_};
    for (const Row& row : rows_) {
        std::vector<std::string>& line = cells.emplace_back(std::vector<std::string>{row.what});
        for (const double value : row.values) line.push_back(number(value));
    }
    std::vector<std::size_t> width(columns_.size(), 0);
    for (const auto& line : cells) {
        for (std::size_t i = 0; i < line.size(); ++i) width[i] = std::max(width[i], line[i].size());
    }
    for (const auto& line : cells) {
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string fill(width[i] - line[i].size(), ' ');
            out << (i == 0 ? line[i] + fill : "  " + fill + line[i]);
        }
        out << '\n';
    }
    for (const std::string& note : notes_) out << note << '\n';
}

void Report::write_csv(std::ostream& out) const {
    for (std::size_t i = 0; i < columns_.size(); ++i) out << (i == 0 ? "\"" : ",\"") << columns_[i] << '"';
    out << '\n';
    for (const Row& row : rows_) {
        out << '"' << row.what << '"';
        for (const double value : row.values) out << ',' << (std::isnan(value) ? "" : number(value));
        out << '\n';
    }
}

void Report::write_json(std::ostream& out) const {
    out << "[\n";
    for (std::size_t r = 0; r < rows_.size(); ++r) {
        out << "  {\"" << columns_[0] << "\": \"" << rows_[r].what << '"';
        for (std::size_t i = 0; i < rows_[r].values.size(); ++i) {
            const double value = rows_[r].values[i];
            out << ", \"" << columns_[i + 1] << "\": " << (std::isnan(value) ? "null" : number(value));
        }
        out << (r + 1 < rows_.size() ? "},\n" : "}\n");
    }
    out << "]\n";
}
