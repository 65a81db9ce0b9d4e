// SPDX-License-Identifier: MIT
// Materials as operators on PSH coefficients.
#pragma once

#include "harmonics/convolution.hpp"
#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// The coefficient matrix of one channel of a material in its surface's frame, cosine included (Eqs. 40, 52,
/// 53): from light over propagation directions to reflected light over propagation directions. Made from
/// response rows at outgoing angles that resolve the lobe, O(order^3) numbers. A material that is defined by
/// a matrix returns that matrix, truncated or padded with zeros. Throws Error(invalid_argument) for a channel
/// the material does not have or an order out of 0..kMaxOrder.
[[nodiscard]] IsotropicMatrix project_material(const Material& material, int channel, int order);

/// The convolution that approximates such a matrix about the mirror direction (supplement E.6): the nearest
/// kernel to the matrix with its outgoing light mirrored in the surface. Light convolved with it is looked up
/// at the mirrored view direction. Throws Error(invalid_argument) unless both orders of the matrix agree and
/// are at most CoefficientMatrix::kMaxDenseOrder.
[[nodiscard]] ConvolutionKernel material_kernel(const IsotropicMatrix& matrix);

}  // namespace nicol
