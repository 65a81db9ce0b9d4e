// SPDX-License-Identifier: MIT
// Calls of nicol_psh.h that all experiments use. Failures throw nicol::Error.
#pragma once

#include <nicol_psh.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <complex>
#include <cstddef>
#include <functional>
#include <numbers>
#include <vector>

#include "common/handles.hpp"

using std::numbers::pi;
using Doubles = std::vector<double>;
using Vec3 = std::array<double, 3>;
using Rotation = std::array<double, 9>;  ///< row-major

/// Returns the number of doubles of one vector of coefficients.
std::size_t vector_size(std::uint32_t order);

double dot(const Vec3& a, const Vec3& b);
Vec3 cross(const Vec3& a, const Vec3& b);
Vec3 unit(const Vec3& a);
Vec3 direction(double theta, double phi);
Vec3 theta_hat(double theta, double phi);
Vec3 phi_hat(double phi);
Vec3 operator*(const Rotation& r, const Vec3& v);
Rotation transposed(const Rotation& r);
/// Returns the rotation by |v| radians about v.
Rotation rotation_about(const Vec3& v);

/// Returns exp(2 i angle) for the angle that rotates the theta-phi frame at w into the frame with x axis `x`.
std::complex<double> frame_phase(const Vec3& x, const Vec3& w);

/// A grid with its transform.
class Grid {
public:
    Grid(nicol_psh_grid kind, std::uint32_t order, std::uint32_t rows, std::uint32_t columns);
    ~Grid();
    Grid(const Grid&) = delete;
    Grid& operator=(const Grid&) = delete;

    [[nodiscard]] std::size_t points() const { return theta.size() * columns; }
    [[nodiscard]] double phi(std::size_t column) const {
        return 2 * pi * static_cast<double>(column) / static_cast<double>(columns);
    }
    /// Returns the solid angle of a point in this row.
    [[nodiscard]] double solid_angle(std::size_t row) const {
        return weight[row] * 2 * pi / static_cast<double>(columns);
    }
    [[nodiscard]] Doubles analyze(const Doubles& samples) const;
    [[nodiscard]] Doubles synthesize(const Doubles& coefficients) const;
    /// Returns the root of the mean over the sphere of |s1|^2 + |s2|^2, or of all four components.
    [[nodiscard]] double rms(const Doubles& samples, bool linear_only) const;

    Doubles theta, weight;
    std::size_t columns;

private:
    nicol_psh_transform transform_ = nullptr;
    std::uint32_t order_;
};

/// Returns Stokes vectors of a field at directions, four doubles each.
Doubles evaluate(std::uint32_t order, const Doubles& field, const std::vector<Vec3>& directions);
Doubles rotate(std::uint32_t order, const Doubles& fields, const Rotation& rotation);
/// Returns the orders up to `order` of a field of higher order.
Doubles cut(const Doubles& field, std::uint32_t order);

/// Returns the wall-clock seconds of a call.
template <class F>
double seconds(F&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Returns the minimum wall-clock seconds of ten calls.
template <class F>
double least_seconds(F&& work) {
    double least = seconds(work);
    for (int i = 0; i < 9; ++i) least = std::min(least, seconds(work));
    return least;
}

double largest_difference(const Doubles& a, const Doubles& b);
