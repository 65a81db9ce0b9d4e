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
    std::string colour;  ///< as in CSS
    bool dashed = false;
    std::vector<Point> points;  ///< those not above 0 are left out
};

struct Panel {
    std::string title;
    std::string x_axis;
    std::string y_axis;
    std::vector<Series> series;
};

/// Panels side by side, `columns` a row; the legend is that of the first.
void write_svg(std::ostream& out, const std::vector<Panel>& panels, int columns);
