// SPDX-License-Identifier: MIT
// The published form of high orders: one convolution kernel a material.
#pragma once

#include <vector>

#include "harmonics/convolution.hpp"
#include "material/material.hpp"

namespace nicol {

/// material_kernel() of orders to kMaxDenseOrder and beyond: without a dense matrix in between, memory grows
/// with the cube of the order instead of its fourth power.
[[nodiscard]] ConvolutionKernel mirrored_kernel(const IsotropicMatrix& matrix);

/// mirrored_kernel(project_material()) of every channel, or a single one for a material without colour.
/// Throws Error(invalid_argument) for an order out of 0..kMaxOrder or channels that do not fit.
[[nodiscard]] std::vector<ConvolutionKernel> mirrored_kernels(const Material& material, int order,
                                                              int channels);

}  // namespace nicol
