// SPDX-License-Identifier: MIT
// Projection of materials to operators on polarized spherical harmonics (PSH).
#pragma once

#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// Returns the coefficient matrix of one channel of a material in its surface's frame, cosine included
/// (Eqs. 40, 52, 53). The matrix maps light over propagation directions to reflected light over propagation
/// directions. Its O(order^3) numbers come from response rows at outgoing angles that resolve the lobe. A
/// material that is defined by a matrix returns that matrix, truncated or padded with zeros. Throws
/// Error(invalid_argument) for a channel that the material does not have or an order outside 0..kMaxOrder.
[[nodiscard]] IsotropicMatrix project_material(const Material& material, int channel, int order);

}  // namespace nicol
