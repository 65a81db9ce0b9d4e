// SPDX-License-Identifier: MIT
#include "field.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

std::size_t vector_size(std::uint32_t order) {
    return 4 * std::size_t{order + 1} * (order + 1);
}

double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Vec3 unit(const Vec3& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}

Vec3 direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Vec3 theta_hat(double theta, double phi) {
    return {std::cos(theta) * std::cos(phi), std::cos(theta) * std::sin(phi), -std::sin(theta)};
}

Vec3 phi_hat(double phi) {
    return {-std::sin(phi), std::cos(phi), 0};
}

Vec3 operator*(const Rotation& r, const Vec3& v) {
    return {r[0] * v[0] + r[1] * v[1] + r[2] * v[2], r[3] * v[0] + r[4] * v[1] + r[5] * v[2],
            r[6] * v[0] + r[7] * v[1] + r[8] * v[2]};
}

Rotation transposed(const Rotation& r) {
    return {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
}

Rotation rotation_about(const Vec3& v) {
    const double angle = std::sqrt(dot(v, v));
    const Vec3 u = unit(v);
    const double c = std::cos(angle), s = std::sin(angle), t = 1 - c;
    return {c + u[0] * u[0] * t,        u[0] * u[1] * t - u[2] * s, u[0] * u[2] * t + u[1] * s,
            u[1] * u[0] * t + u[2] * s, c + u[1] * u[1] * t,        u[1] * u[2] * t - u[0] * s,
            u[2] * u[0] * t - u[1] * s, u[2] * u[1] * t + u[0] * s, c + u[2] * u[2] * t};
}

std::complex<double> frame_phase(const Vec3& x, const Vec3& w) {
    const double phi = std::atan2(w[1], w[0]);
    const double theta = std::atan2(std::hypot(w[0], w[1]), w[2]);
    const std::complex<double> e(dot(x, theta_hat(theta, phi)), dot(x, phi_hat(phi)));
    return e * e / std::norm(e);
}

Grid::Grid(nicol_psh_grid kind, std::uint32_t order, std::uint32_t rows, std::uint32_t columns_)
    : theta(rows), weight(rows), columns(columns_), order_(order) {
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.grid = kind;
    sampling.order = order;
    sampling.rows = rows;
    sampling.columns = columns_;
    check(nicol_psh_transform_create(&sampling, &transform_));
    check(nicol_psh_transform_get_rows(transform_, theta.data(), weight.data(), theta.size()));
}

Grid::~Grid() {
    nicol_psh_transform_release(transform_);
}

Doubles Grid::analyze(const Doubles& samples) const {
    const std::size_t vectors = samples.size() / (4 * points());
    Doubles out(vectors * vector_size(order_));
    check(nicol_psh_analyze(transform_, vectors, samples.data(), samples.size(), out.data(), out.size()));
    return out;
}

Doubles Grid::synthesize(const Doubles& coefficients) const {
    const std::size_t vectors = coefficients.size() / vector_size(order_);
    Doubles out(vectors * 4 * points());
    check(nicol_psh_synthesize(transform_, vectors, coefficients.data(), coefficients.size(), out.data(),
                               out.size()));
    return out;
}

double Grid::rms(const Doubles& samples, bool linear_only) const {
    double sum = 0;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t p = i % 4;
        if (linear_only && (p == 0 || p == 3)) continue;
        sum += solid_angle(i / 4 / columns) * samples[i] * samples[i];
    }
    return std::sqrt(sum / (4 * pi));
}

Doubles evaluate(std::uint32_t order, const Doubles& field, const std::vector<Vec3>& directions) {
    Doubles out(4 * directions.size());
    check(nicol_psh_evaluate(order, 1, field.data(), field.size(), directions.data()->data(),
                             3 * directions.size(), out.data(), out.size()));
    return out;
}

Doubles rotate(std::uint32_t order, const Doubles& fields, const Rotation& rotation) {
    Doubles out(fields.size());
    check(nicol_psh_rotate(order, fields.size() / vector_size(order), fields.data(), fields.size(),
                           rotation.data(), out.data(), out.size()));
    return out;
}

Doubles cut(const Doubles& field, std::uint32_t order) {
    return {field.begin(), field.begin() + static_cast<std::ptrdiff_t>(vector_size(order))};
}

double largest_difference(const Doubles& a, const Doubles& b) {
    if (a.size() != b.size()) throw std::runtime_error("results of different sizes cannot be compared");
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
}
