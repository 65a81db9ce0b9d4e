// SPDX-License-Identifier: MIT
// Materials as operators on PSH coefficients.
#pragma once

#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// The coefficient matrix of one channel of a material in its surface's frame, cosine included (Eqs. 40, 52,
/// 53): from light over propagation directions to reflected light over propagation directions. Made from
/// response rows at outgoing angles that resolve the lobe, O(order^3) numbers. A material that is defined by
/// a matrix returns that matrix, truncated or padded with zeros. Throws Error(invalid_argument) for a channel
/// the material does not have or an order out of 0..kMaxOrder.
[[nodiscard]] IsotropicMatrix project_material(const Material& material, int channel, int order);

}  // namespace nicol
