// SPDX-License-Identifier: MIT
// Curves over logarithmic axes as SVG.
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

struct Point {
    double x;
    double y;
    std::string label;
};

struct Series {
    std::string name;
    std::string colour;  ///< CSS colour
    bool dashed = false;
    std::vector<Point> points;  ///< points with x or y <= 0 are left out
};

struct Panel {
    std::string title;
    std::string x_axis;
    std::string y_axis;
    std::vector<Series> series;
};

/// Writes panels side by side, `columns` per row; the legend is that of the first panel.
void write_svg(std::ostream& out, const std::vector<Panel>& panels, int columns);
