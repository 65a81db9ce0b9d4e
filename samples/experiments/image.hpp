// SPDX-License-Identifier: MIT
// Panels of numbers as colours, side by side in a PNG file.
#pragma once

#include <string>
#include <vector>

/// Numbers [row][column].
struct Panel {
    std::size_t width = 0, height = 0;
    std::vector<double> values;
};

/// Colours of signed numbers: blue below zero, white, red above; full colour at `scale`.
struct Signed {
    double scale;
};
/// Colours of magnitudes: from white at 10^-decades of `scale` or less to black at `scale`, logarithmic.
struct Magnitude {
    double scale;
    double decades;
};

class Image {
public:
    /// Makes an image of panels of one size in rows of `across`.
    explicit Image(std::size_t across) : across_(across) {}
    void add(const Panel& panel, Signed colours);
    void add(const Panel& panel, Magnitude colours);
    /// Writes each number as zoom x zoom pixels. Throws std::runtime_error naming the path.
    void write(const std::string& path, std::size_t zoom) const;

private:
    struct Coloured {
        std::size_t width, height;
        std::vector<unsigned char> rgb;
    };
    std::size_t across_;
    std::vector<Coloured> panels_;
};
