// SPDX-License-Identifier: MIT
// Rows and columns of images with their names, as one PNG file.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "image.hpp"

/// An image of 8-bit RGB with equally many rows and columns.
struct Panel {
    std::size_t size = 0;
    std::vector<std::uint8_t> rgb;
};

/// Scale from numbers to colours, common to all panels that are compared.
struct Exposure {
    double s0 = 1;         ///< value shown as white
    double polarized = 1;  ///< |s1| or |s2| shown at full colour
};
/// Returns the exposure with white at the 98th and full colour at the 99th percentile over the object.
Exposure expose(const Image& image);

/// Conversion of images to panels, which are means over whole pixels and grey outside the object.
class Colouring {
public:
    Colouring(Exposure exposure, std::size_t panel_size) : exposure_(exposure), size_(panel_size) {}
    /// Returns s0 with the sRGB curve; negative light is black.
    [[nodiscard]] Panel s0(const Image& image) const;
    /// Returns the mean of the channels of s1 or s2 (p 1 or 2): red negative, green positive.
    [[nodiscard]] Panel polarized(const Image& image, std::size_t p) const;
    /// Returns pixels that violate Eq. 70 in some channel: red for negative s0, yellow for more polarization
    /// than light, over a dim s0.
    [[nodiscard]] Panel unphysical(const Image& image) const;

private:
    Exposure exposure_;
    std::size_t size_;
};

class Sheet {
public:
    explicit Sheet(std::vector<std::string> columns) : columns_(std::move(columns)) {}
    /// Adds a row of one panel per column, all of one size.
    void add_row(std::string name, std::vector<Panel> panels);
    void add_note(std::string line) { notes_.push_back(std::move(line)); }
    /// Writes a PNG file. Throws std::runtime_error if it cannot be written.
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
