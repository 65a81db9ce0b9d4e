// SPDX-License-Identifier: MIT
// The published method for high orders: one convolution kernel per material.
#pragma once

#include <vector>

#include "harmonics/convolution.hpp"
#include "material/material.hpp"

namespace nicol {

/// Returns the convolution that approximates a material's matrix about the mirror direction (supplement E.6):
/// the kernel nearest to the matrix after its outgoing light is mirrored at the surface. Light convolved with
/// the kernel is evaluated at the mirrored view direction. Throws Error(invalid_argument) unless both orders
/// of the matrix agree.
[[nodiscard]] ConvolutionKernel mirrored_kernel(const IsotropicMatrix& matrix);

/// Returns mirrored_kernel(project_material()) of every channel, or a single kernel for a material without
/// colour. Throws Error(invalid_argument) for an order out of 0..kMaxOrder or channels that do not fit.
[[nodiscard]] std::vector<ConvolutionKernel> mirrored_kernels(const Material& material, int order,
                                                              int channels);

}  // namespace nicol
