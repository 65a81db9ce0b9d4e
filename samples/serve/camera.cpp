// SPDX-License-Identifier: MIT
#include "camera.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>

#include "common/handles.hpp"

namespace {

using Vector = std::array<double, 3>;

constexpr double kDegree = std::numbers::pi / 180;

/// Returns a column of a row-major 4 x 4 matrix.
Vector column(const double m[16], std::size_t c) {
    return {m[c], m[4 + c], m[8 + c]};
}

double length(const Vector& v) {
    return std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

double rounded(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.4g", value);
    return std::strtod(text.data(), nullptr);
}

/// Returns the two horizontal axes: azimuth 0 and azimuth 90.
std::array<std::size_t, 2> horizontal(std::uint32_t up) {
    return {(up + 1) % 3, (up + 2) % 3};
}

/// Returns a right-handed rotation about a world axis, in radians.
std::array<double, 9> rotation(std::size_t axis, double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
    std::array<double, 9> m{};
    m[axis * 3 + axis] = 1;
    m[a * 3 + a] = m[b * 3 + b] = c;
    m[a * 3 + b] = -s;
    m[b * 3 + a] = s;
    return m;
}

/// Sets the matrix to rotation * matrix; the last row stays.
void set_rotation(const std::array<double, 9>& r, double m[16]) {
    for (std::size_t c = 0; c < 4; ++c) {
        const Vector v = column(m, c);
        for (std::size_t row = 0; row < 3; ++row)
            m[row * 4 + c] = r[row * 3] * v[0] + r[row * 3 + 1] * v[1] + r[row * 3 + 2] * v[2];
    }
}

}  // namespace

std::uint32_t vertical_axis(const nicol_camera& camera) {
    const Vector up = column(camera.to_world, 1);
    std::uint32_t axis = 1;  // choice if two axes are equally near
    for (std::uint32_t i = 0; i < 3; ++i)
        if (std::abs(up[i]) > std::abs(up[axis]) + 1e-6) axis = i;
    return axis;
}

Orbit orbit_of(const nicol_camera& camera, std::uint32_t up, double depth) {
    const Vector forward = column(camera.to_world, 2), place = column(camera.to_world, 3);
    const auto [front, side] = horizontal(up);
    Orbit orbit;
    orbit.distance = rounded(depth);
    for (std::size_t i = 0; i < 3; ++i)
        orbit.target[i] = rounded(place[i] + depth * forward[i] / length(forward));
    const double sine = std::clamp(-forward[up] / length(forward), -1.0, 1.0);
    orbit.elevation = std::clamp(rounded(std::asin(sine) / kDegree), -89.0, 89.0);
    orbit.azimuth = rounded(std::atan2(-forward[side], -forward[front]) / kDegree);
    return orbit;
}

nicol_camera camera_of(const View& view, const nicol_camera& own, std::uint32_t up) {
    nicol_camera camera = own;
    if (view.fov > 0) camera.fov = view.fov;
    if (view.camera == CameraKind::matrix) std::ranges::copy(view.matrix, camera.to_world);
    if (view.camera != CameraKind::orbit) return camera;

    const auto [front, side] = horizontal(up);
    const double flat = std::cos(view.orbit.elevation * kDegree) * view.orbit.distance;
    Vector origin = view.orbit.target;
    origin[front] += flat * std::cos(view.orbit.azimuth * kDegree);
    origin[side] += flat * std::sin(view.orbit.azimuth * kDegree);
    origin[up] += std::sin(view.orbit.elevation * kDegree) * view.orbit.distance;
    Vector vertical{};
    vertical[up] = 1;
    check(nicol_camera_look_at(&camera, origin.data(), view.orbit.target.data(), vertical.data()));
    // The scale of the axes is the size of an orthographic image.
    for (std::size_t c = 0; c < 2; ++c) {
        const double scale = length(column(own.to_world, c));
        for (std::size_t row = 0; row < 3; ++row) camera.to_world[row * 4 + c] *= scale;
    }
    return camera;
}

void rotate_light(const View& view, std::uint32_t up, const double own[16], double rotated[16]) {
    std::copy_n(own, 16, rotated);
    set_rotation(rotation(up, view.light * kDegree), rotated);
    set_rotation(rotation(horizontal(up)[1], view.light_tilt * kDegree), rotated);
}
