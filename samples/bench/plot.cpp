// SPDX-License-Identifier: MIT
#include "plot.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <ostream>

namespace {

constexpr double kPanelWidth = 460;
constexpr double kPanelHeight = 380;
constexpr double kLeft = 70;
constexpr double kRight = 20;
constexpr double kTop = 36;
constexpr double kBottom = 54;
constexpr double kLegendLine = 20;

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%g", value);
    return text;
}

std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        if (c == '&')
            out += "&amp;";
        else if (c == '<')
            out += "&lt;";
        else
            out += c;
    }
    return out;
}

bool drawable(const Point& point) {
    return point.x > 0 && point.y > 0 && std::isfinite(point.x) && std::isfinite(point.y);
}

// Map from value to position on a logarithmic scale.
struct Axis {
    double least = std::numeric_limits<double>::infinity();
    double most = 0;
    double from = 0;  // position of the smallest value
    double to = 0;

    void include(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
    void widen() {
        if (most <= 0) least = most = 1;
        least /= 1.25;
        most *= 1.25;
    }
    [[nodiscard]] double at(double value) const {
        return from + (to - from) * std::log(value / least) / std::log(most / least);
    }
    // Returns 1, 2 and 5 times powers of ten.
    [[nodiscard]] std::vector<double> ticks() const {
        std::vector<double> list;
        for (double decade = std::pow(10.0, std::floor(std::log10(least))); decade <= most; decade *= 10) {
            for (const double step : {1.0, 2.0, 5.0}) {
                if (decade * step >= least && decade * step <= most) list.push_back(decade * step);
            }
        }
        return list;
    }
};

void write_text(std::ostream& out, double x, double y, const char* anchor, const std::string& text,
                const char* more = "") {
    out << "<text x='" << x << "' y='" << y << "' text-anchor='" << anchor << "'" << more << ">"
        << escaped(text) << "</text>\n";
}

void write_line(std::ostream& out, double x1, double y1, double x2, double y2, const char* colour) {
    out << "<line x1='" << x1 << "' y1='" << y1 << "' x2='" << x2 << "' y2='" << y2 << "' stroke='" << colour
        << "'/>\n";
}

void write_series(std::ostream& out, const Series& series, const Axis& x, const Axis& y) {
    out << "<polyline fill='none' stroke-width='1.6' stroke='" << series.colour << "'"
        << (series.dashed ? " stroke-dasharray='5 4'" : "") << " points='";
    for (const Point& p : series.points) {
        if (drawable(p)) out << x.at(p.x) << ',' << y.at(p.y) << ' ';
    }
    out << "'/>\n";
    for (const Point& p : series.points) {
        if (!drawable(p)) continue;
        out << "<circle r='3' cx='" << x.at(p.x) << "' cy='" << y.at(p.y) << "' fill='" << series.colour
            << "'/>\n";
        write_text(out, x.at(p.x) + 5, y.at(p.y) - 4, "start", p.label, " font-size='10'");
    }
}

void write_panel(std::ostream& out, const Panel& panel) {
    Axis x{.from = kLeft, .to = kPanelWidth - kRight};
    Axis y{.from = kPanelHeight - kBottom, .to = kTop};
    for (const Series& series : panel.series) {
        for (const Point& p : series.points) {
            if (drawable(p)) x.include(p.x), y.include(p.y);
        }
    }
    x.widen(), y.widen();
    for (const double tick : x.ticks()) {
        write_line(out, x.at(tick), y.from, x.at(tick), y.to, "#ddd");
        write_text(out, x.at(tick), y.from + 16, "middle", number(tick));
    }
    for (const double tick : y.ticks()) {
        write_line(out, x.from, y.at(tick), x.to, y.at(tick), "#ddd");
        write_text(out, x.from - 6, y.at(tick) + 4, "end", number(tick));
    }
    write_line(out, x.from, y.from, x.to, y.from, "black");
    write_line(out, x.from, y.from, x.from, y.to, "black");
    write_text(out, kPanelWidth / 2, kTop - 14, "middle", panel.title, " font-weight='bold'");
    write_text(out, (x.from + x.to) / 2, kPanelHeight - 16, "middle", panel.x_axis);
    const std::string rotated = " transform='rotate(-90 16 " + number((y.from + y.to) / 2) + ")'";
    write_text(out, 16, (y.from + y.to) / 2, "middle", panel.y_axis, rotated.c_str());
    for (const Series& series : panel.series) write_series(out, series, x, y);
}

void write_legend(std::ostream& out, const std::vector<Series>& list, double y) {
    for (const Series& series : list) {
        out << "<line x1='" << kLeft << "' x2='" << kLeft + 34 << "' y1='" << y - 4 << "' y2='" << y - 4
            << "' stroke-width='1.6' stroke='" << series.colour << "'"
            << (series.dashed ? " stroke-dasharray='5 4'" : "") << "/>\n";
        write_text(out, kLeft + 42, y, "start", series.name);
        y += kLegendLine;
    }
}

}  // namespace

void write_svg(std::ostream& out, const std::vector<Panel>& panels, int columns) {
    const int count = static_cast<int>(panels.size());
    const int rows = (count + columns - 1) / columns;
    const double legend = kLegendLine * static_cast<double>(panels.front().series.size() + 1);
    out << "<svg xmlns='http://www.w3.org/2000/svg' width='" << kPanelWidth * columns << "' height='"
        << kPanelHeight * rows + legend
        << "' font-family='sans-serif' font-size='12'>\n<rect width='100%' height='100%' fill='white'/>\n";
    for (int i = 0; i < count; ++i) {
        out << "<g transform='translate(" << kPanelWidth * (i % columns) << ' '
            << kPanelHeight * (i / columns) << ")'>\n";
        write_panel(out, panels[static_cast<std::size_t>(i)]);
        out << "</g>\n";
    }
    write_legend(out, panels.front().series, kPanelHeight * rows + kLegendLine);
    out << "</svg>\n";
}
