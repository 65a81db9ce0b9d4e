// SPDX-License-Identifier: MIT
// Gains of isotropic lobes, which filter coefficients by order.
#pragma once

#include <vector>

namespace nicol {

/// Factors by which a filter multiplies the coefficients of each order, from order 0 on.
using OrderGains = std::vector<double>;

/// Returns exp(-l (l + 1) width^2 / 2) for the orders first..last, 0 below first: a Gaussian lobe of angular
/// standard deviation `width`, radians. Throws Error(invalid_argument) unless 0 <= first <= last <= kMaxOrder
/// and 0 <= width <= 4.
[[nodiscard]] OrderGains gaussian_gains(double width, int first, int last);

/// Returns the gains of the clamped cosine of a diffuse surface over pi, for the orders first..last. Throws
/// as gaussian_gains() does.
[[nodiscard]] OrderGains cosine_gains(int first, int last);

}  // namespace nicol
