// SPDX-License-Identifier: MIT
// Sampling grids on the sphere.
#pragma once

#include <span>
#include <vector>

#include <glm/vec3.hpp>

#include "polarization/stokes.hpp"

namespace nicol {

/// Circles of latitude from north to south with weights for the integral over cos(theta):
/// sum_j weight[j] f(theta[j]) = int_0^pi f(theta) sin(theta) dtheta; the weights sum to 2.
/// sin_half and cos_half are sine and cosine of theta/2, exactly mirrored between north and south.
struct LatitudeRows {
    std::vector<double> theta;
    std::vector<double> sin_half;
    std::vector<double> cos_half;
    std::vector<double> weight;

    [[nodiscard]] int count() const noexcept { return static_cast<int>(theta.size()); }
};

/// Returns rows at the roots of the Legendre polynomial P_count: exact for products of two fields of order <
/// count.
[[nodiscard]] LatitudeRows gauss_legendre_rows(int count);

/// Returns rows at the pixel centres of an equirectangular image, theta_j = (j + 1/2) pi / count, with the
/// weights of Fejer's first rule: exact for products of two fields when the sum of their orders is < count.
[[nodiscard]] LatitudeRows fejer_rows(int count);

/// Returns rows at theta_j = j pi / (count - 1), both poles included (Clenshaw-Curtis): exact for the
/// products for which fejer_rows() is exact. count >= 2.
[[nodiscard]] LatitudeRows clenshaw_curtis_rows(int count);

/// Largest counts of rows. The functions above throw Error(invalid_argument) for a count below 1
/// (clenshaw_curtis_rows: 2) or above kMaxRows (gauss_legendre_rows: kMaxGaussRows).
inline constexpr int kMaxRows = 1 << 15;
inline constexpr int kMaxGaussRows = 1 << 14;

}  // namespace nicol
