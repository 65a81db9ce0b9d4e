// SPDX-License-Identifier: MIT
// Rows and columns of images with their names, as one PNG file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image.hpp"

/// 8-bit RGB, as many rows as columns.
struct Panel {
    std::size_t size = 0;
    std::vector<std::uint8_t> rgb;
};

/// How numbers become colours, the same for all panels that are to be compared.
struct Exposure {
    double s0 = 1;         ///< shown as white
    double polarized = 1;  ///< |s1| and |s2| shown at full colour
};
/// White is the 98th, full colour the 99th percentile over the object.
Exposure expose(const Image& image);

/// Images shrink by means over whole pixels. Where there is no object they are grey.
class Colouring {
public:
    Colouring(Exposure exposure, std::size_t panel_size) : exposure_(exposure), size_(panel_size) {}
    /// s0 with the sRGB curve; negative light is black.
    [[nodiscard]] Panel s0(const Image& image) const;
    /// Mean of the channels of s1 or s2 (p 1 or 2): red negative, green positive.
    [[nodiscard]] Panel polarized(const Image& image, std::size_t p) const;
    /// Where Eq. 70 does not hold in some channel: red for negative s0, yellow for more polarization than
    /// light, over a dim s0.
    [[nodiscard]] Panel unphysical(const Image& image) const;

private:
    Exposure exposure_;
    std::size_t size_;
};

class Sheet {
public:
    explicit Sheet(std::vector<std::string> columns) : columns_(std::move(columns)) {}
    /// A panel for each column, all of one size.
    void add_row(std::string name, std::vector<Panel> panels);
    void add_note(std::string line) { notes_.push_back(std::move(line)); }
    /// Throws std::runtime_error where it cannot be written.
    void write(const std::string& path) const;

private:
    struct Row {
        std::string name;
        std::vector<Panel> panels;
    };
    std::vector<std::string> columns_;
    std::vector<Row> rows_;
    std::vector<std::string> notes_;
};
