// SPDX-License-Identifier: MIT
// Isotropic lobes as filters of coefficients.
#pragma once

#include <vector>

namespace nicol {

/// What a filter multiplies the coefficients of each order by, from order 0 on.
using OrderGains = std::vector<double>;

/// exp(-l (l + 1) width^2 / 2) for the orders first..last, 0 below first: a Gaussian lobe of that angular
/// standard deviation, radians. Throws Error(invalid_argument) unless 0 <= first <= last <= kMaxOrder and
/// 0 <= width <= 4.
[[nodiscard]] OrderGains gaussian_gains(double width, int first, int last);

/// The clamped cosine of a diffuse surface over pi, for the orders first..last. Throws as gaussian_gains().
[[nodiscard]] OrderGains cosine_gains(int first, int last);

}  // namespace nicol
