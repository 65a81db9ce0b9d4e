// SPDX-License-Identifier: MIT
#include "harmonics.hpp"

#include <nicol_psh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "common/handles.hpp"
#include "sheet.hpp"

namespace {

using Vector = std::array<double, 3>;
constexpr double kPi = std::numbers::pi;

std::uint8_t byte(double value) {
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0, 1.0)));
}

void add(Panel& panel, double red, double green, double blue) {
    for (const double value : {red, green, blue}) panel.rgb.push_back(byte(std::sqrt(std::max(value, 0.0))));
}

// Adds a pixel for a signed value: red negative, green positive.
void add_signed(Panel& panel, double value) {
    add(panel, -value, value, 0);
}

// Adds a pixel whose hue is an angle of polarization, 0 to pi, and whose brightness is an amount.
void add_angle(Panel& panel, double angle, double amount) {
    const auto wave = [&](double shift) { return amount * (0.5 + 0.5 * std::cos(2 * angle - shift)); };
    add(panel, wave(0), wave(2 * kPi / 3), wave(4 * kPi / 3));
}

void add_background(Panel& panel) {
    add(panel, 0.01, 0.01, 0.01);
}

std::size_t index(int l, int m) {
    return static_cast<std::size_t>(l * l + l + m);
}

std::vector<double> evaluate(std::uint32_t order, const std::vector<double>& coefficients,
                             const std::vector<double>& directions) {
    std::vector<double> stokes(directions.size() / 3 * 4);
    check(nicol_psh_evaluate(order, 1, coefficients.data(), coefficients.size(), directions.data(),
                             directions.size(), stokes.data(), stokes.size()));
    return stokes;
}

// An orthographic view of the unit sphere: the directions of an image to the right, down and to the viewer.
struct SphereView {
    const char* name;
    Vector right, down, near;
};
const SphereView kNorth{"north pole", {1, 0, 0}, {0, -1, 0}, {0, 0, 1}};
const SphereView kSide{"side", {0, 1, 0}, {0, 0, -1}, {1, 0, 0}};
const SphereView kSouth{"south pole", {1, 0, 0}, {0, 1, 0}, {0, 0, -1}};

double dot(const Vector& a, const Vector& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Returns the visible points of the sphere, row by row; zeros where a pixel misses the sphere.
std::vector<Vector> points(const SphereView& view, std::size_t size) {
    std::vector<Vector> out;
    for (std::size_t i = 0; i < size * size; ++i) {
        const auto place = [&](std::size_t k) {
            return 2.1 * ((static_cast<double>(k) + 0.5) / static_cast<double>(size) - 0.5);
        };
        const double x = place(i % size), y = place(i / size);
        const double z = std::sqrt(std::max(1 - x * x - y * y, 0.0));
        Vector& point = out.emplace_back(Vector{});
        if (z > 0)
            for (std::size_t c = 0; c < 3; ++c)
                point[c] = x * view.right[c] + y * view.down[c] + z * view.near[c];
    }
    return out;
}

// Returns the angle in the image, counter-clockwise from the right, of the polarization s1 + i s2 at a point.
double angle_in_view(const SphereView& view, const Vector& d, std::complex<double> linear) {
    const double sine = std::max(std::hypot(d[0], d[1]), 1e-12);
    const Vector theta{d[0] * d[2] / sine, d[1] * d[2] / sine, -sine}, phi{-d[1] / sine, d[0] / sine, 0};
    const double angle = std::arg(linear) / 2;
    Vector axis{};
    for (std::size_t c = 0; c < 3; ++c) axis[c] = std::cos(angle) * theta[c] + std::sin(angle) * phi[c];
    return std::atan2(-dot(axis, view.down), dot(axis, view.right));
}

struct Ball {
    std::vector<Vector> points;
    std::vector<std::complex<double>> linear;  // s1 + i s2 in the theta-phi frame
};

// Returns the spin-2 harmonic of order 2 and degree m at the points of a view.
Ball ball(const SphereView& view, int m, std::size_t size) {
    std::vector<double> coefficients(4 * index(3, -3));
    coefficients[4 * index(2, m) + 1] = 1;
    Ball out{.points = points(view, size), .linear = {}};
    std::vector<double> directions;
    for (const Vector& d : out.points) {
        const bool seen = dot(d, d) > 0;
        directions.insert(directions.end(), {seen ? d[0] : 1, d[1], d[2]});
    }
    const std::vector<double> stokes = evaluate(2, coefficients, directions);
    for (std::size_t i = 0; i < out.points.size(); ++i)
        out.linear.emplace_back(stokes[4 * i + 1], stokes[4 * i + 2]);
    return out;
}

template <class Add>
std::vector<Panel> columns(const SphereView& view, std::size_t size, Add add_pixel) {
    std::vector<Panel> panels;
    for (int m = -2; m <= 2; ++m) {
        const Ball shown = ball(view, m, size);
        Panel& panel = panels.emplace_back(Panel{.size = size, .rgb = {}});
        for (std::size_t i = 0; i < shown.points.size(); ++i) {
            if (dot(shown.points[i], shown.points[i]) > 0)
                add_pixel(panel, shown.points[i], shown.linear[i]);
            else
                add_background(panel);
        }
    }
    return panels;
}

// Coefficients of the mean of a light's channels.
std::vector<double> mean_light(const std::filesystem::path& light, std::uint32_t order) {
    std::uint32_t channels = 0;
    check(nicol_psh_project_file(light.c_str(), order, &channels, nullptr, 0));
    const std::size_t each = std::size_t{4} * (order + 1) * (order + 1);
    std::vector<double> all(channels * each), mean(each);
    check(nicol_psh_project_file(light.c_str(), order, nullptr, all.data(), all.size()));
    for (std::size_t i = 0; i < all.size(); ++i) mean[i % each] += all[i] / channels;
    return mean;
}

// Samples [row][column][4] of the orders `from` to `to`: theta grows down, phi to the right.
std::vector<double> samples(std::vector<double> coefficients, std::uint32_t order, int from, int to,
                            std::size_t size) {
    std::fill_n(coefficients.begin(), 4 * index(from, -from), 0);
    std::fill(coefficients.begin() +
                  static_cast<std::ptrdiff_t>(std::min(4 * index(to + 1, -to - 1), coefficients.size())),
              coefficients.end(), 0);
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.order = order;
    sampling.rows = sampling.columns = static_cast<std::uint32_t>(size);
    nicol_psh_transform transform = nullptr;
    check(nicol_psh_transform_create(&sampling, &transform));
    std::vector<double> out(4 * size * size);
    const nicol_result result =
        nicol_psh_synthesize(transform, 1, coefficients.data(), coefficients.size(), out.data(), out.size());
    nicol_psh_transform_release(transform);
    check(result);
    return out;
}

}  // namespace

void write_spin_harmonics(std::size_t size, const std::string& path) {
    const double largest = std::sqrt(5 / (4 * kPi));  // of every degree's modulus, at a pole or between
    Sheet sheet({"m = -2", "m = -1", "m = 0", "m = 1", "m = 2"});
    for (const SphereView* view : {&kNorth, &kSide, &kSouth}) {
        sheet.add_row(std::string("polarization, ") + view->name,
                      columns(*view, size, [&](Panel& panel, const Vector& d, std::complex<double> linear) {
                          add_angle(panel, angle_in_view(*view, d, linear), std::abs(linear) / largest);
                      }));
    }
    const auto add_component = [&](const char* name, auto component) {
        sheet.add_row(name,
                      columns(kSide, size, [&](Panel& panel, const Vector&, std::complex<double> linear) {
                          add_signed(panel, component(linear) / largest);
                      }));
    };
    add_component("s1 in the theta-phi frame, side",
                  [](std::complex<double> linear) { return linear.real(); });
    add_component("s2 in the theta-phi frame, side",
                  [](std::complex<double> linear) { return linear.imag(); });
    sheet.add_note("spin-2 harmonics of order 2. polarization: hue is the angle in the image");
    sheet.add_note("only m = -2 is not 0 at the north pole, only m = 2 at the south pole");
    sheet.add_note("s1, s2: red negative, green positive. m times along a circle of latitude");
    sheet.write(path);
}

void write_decomposition(const std::filesystem::path& light, std::size_t size, const std::string& path) {
    // The transform needs 2 order + 1 columns.
    const auto order = static_cast<std::uint32_t>(std::min<std::size_t>((size - 1) / 2, 100));
    const std::vector<double> coefficients = mean_light(light, order);
    const int last = static_cast<int>(order);
    const std::vector<double> all = samples(coefficients, order, 0, last, size);
    std::array<double, 3> unit{};
    for (std::size_t p = 0; p < 3; ++p) {
        std::vector<double> values;
        for (std::size_t i = p; i < all.size(); i += 4) values.push_back(std::abs(all[i]));
        const auto place = values.begin() + static_cast<std::ptrdiff_t>(values.size() * 98 / 100);
        std::nth_element(values.begin(), place, values.end());
        unit[p] = std::max(*place, 1e-12);
    }
    unit[1] = unit[2] = std::max(unit[1], unit[2]);
    Sheet sheet({"s0", "s1", "s2"});
    const auto add_orders = [&](const std::string& name, int from, int to) {
        const std::vector<double> field = samples(coefficients, order, from, to, size);
        std::vector<Panel> panels;
        for (std::size_t p = 0; p < 3; ++p) {
            Panel& panel = panels.emplace_back(Panel{.size = size, .rgb = {}});
            for (std::size_t i = p; i < field.size(); i += 4) add_signed(panel, field[i] / unit[p]);
        }
        sheet.add_row(name, std::move(panels));
    };
    add_orders("the light, orders 0 to " + std::to_string(last), 0, last);
    for (int l = 0; l <= 4; ++l) add_orders("order " + std::to_string(l), l, l);
    add_orders("orders 0 to 4 together", 0, 4);
    add_orders("orders 0 to 9 together", 0, 9);
    sheet.add_note("theta down, phi to the right, in the theta-phi frame. red negative, green positive");
    sheet.add_note("s1 and s2 have no orders 0 and 1");
    sheet.write(path);
}
