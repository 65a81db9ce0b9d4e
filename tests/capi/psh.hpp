// SPDX-License-Identifier: MIT
// What the tests of the mathematics share.
#pragma once

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "capi.hpp"

namespace capi_test {

using std::numbers::pi;
using Vec3 = std::array<double, 3>;
using Doubles = std::vector<double>;

inline std::size_t vector_size(std::uint32_t order) {
    return 4 * std::size_t{order + 1} * (order + 1);
}
inline std::size_t position(int l, int m, int p) {
    return static_cast<std::size_t>(4 * (l * l + l + m) + p);
}

inline double random_number(std::mt19937& random) {
    return std::uniform_real_distribution<double>(-1, 1)(random);
}
inline Doubles random_numbers(std::mt19937& random, std::size_t count) {
    Doubles out(count);
    for (double& x : out) x = random_number(random);
    return out;
}
/// Vectors without a part of spin 2 below l = 2.
inline Doubles random_fields(std::mt19937& random, std::uint32_t order, std::size_t vectors = 1) {
    Doubles out = random_numbers(random, vectors * vector_size(order));
    for (std::size_t v = 0; v < vectors; ++v)
        for (std::size_t i = 0; i < std::min<std::size_t>(4, (order + 1) * (order + 1)); ++i)
            out[v * vector_size(order) + 4 * i + 1] = out[v * vector_size(order) + 4 * i + 2] = 0;
    return out;
}

inline double dot(const Vec3& a, const Vec3& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
inline Vec3 cross(const Vec3& a, const Vec3& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
inline Vec3 unit(const Vec3& a) {
    const double length = std::sqrt(dot(a, a));
    return {a[0] / length, a[1] / length, a[2] / length};
}
inline Vec3 random_direction(std::mt19937& random) {
    return unit({random_number(random), random_number(random), random_number(random)});
}
inline Vec3 direction(double theta, double phi) {
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}
/// theta-hat and phi-hat; not on the z axis.
inline std::array<Vec3, 2> theta_phi(const Vec3& w) {
    const Vec3 phi = unit({-w[1], w[0], 0});
    return {cross(phi, w), phi};
}

using Rotation = std::array<double, 9>;
inline Vec3 operator*(const Rotation& r, const Vec3& v) {
    return {r[0] * v[0] + r[1] * v[1] + r[2] * v[2], r[3] * v[0] + r[4] * v[1] + r[5] * v[2],
            r[6] * v[0] + r[7] * v[1] + r[8] * v[2]};
}
inline Rotation transposed(const Rotation& r) {
    return {r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]};
}
inline Rotation random_rotation(std::mt19937& random) {
    const Vec3 x = random_direction(random);
    const Vec3 y = unit(cross(random_direction(random), x));
    const Vec3 z = cross(x, y);
    return {x[0], y[0], z[0], x[1], y[1], z[1], x[2], y[2], z[2]};
}

/// Components of s, measured in a frame whose x axis is `x`, in the theta-phi frame of w.
inline std::array<double, 4> in_theta_phi(const double* s, const Vec3& x, const Vec3& w) {
    const auto axes = theta_phi(w);
    const double angle = std::atan2(dot(x, axes[1]), dot(x, axes[0]));
    const auto rotated = std::complex(s[1], s[2]) * std::polar(1.0, 2 * angle);
    return {s[0], rotated.real(), rotated.imag(), s[3]};
}
inline std::array<double, 4> value(std::uint32_t order, const double* field, const Vec3& w) {
    std::array<double, 4> s{};
    OK(nicol_psh_evaluate(order, 1, field, vector_size(order), w.data(), 3, s.data(), 4));
    return s;
}

inline double difference(const Doubles& a, const Doubles& b) {
    REQUIRE(a.size() == b.size());
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        REQUIRE(std::isfinite(a[i]));
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

inline nicol_psh_transform make_transform(nicol_psh_grid grid, std::uint32_t order, std::uint32_t rows = 0,
                                          std::uint32_t columns = 0, double phi0 = 0) {
    nicol_psh_sampling sampling = NICOL_PSH_SAMPLING_INIT;
    sampling.grid = grid;
    sampling.order = order;
    sampling.rows = rows;
    sampling.columns = columns;
    sampling.phi0 = phi0;
    nicol_psh_transform transform = nullptr;
    OK(nicol_psh_transform_create(&sampling, &transform));
    return transform;
}

}  // namespace capi_test
