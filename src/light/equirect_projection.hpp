// SPDX-License-Identifier: MIT
// Conversion between equirectangular images and PSH coefficients.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// Returns coefficients, over propagation directions in the world's axes, of the function that is bilinear
/// between the pixels of `view`, which are at least 2 x 2. Because the pixels are not taken as points, light
/// and background agree at any resolution.
[[nodiscard]] PshVector project_equirect(const EquirectView& view, int order);

/// Returns the coefficients of the light without orders above `order` of which the pixels are samples. Throws
/// Error(invalid_argument) for fewer than 2 order + 1 columns or rows.
[[nodiscard]] PshVector project_samples_of(const EquirectImage& image, int order);

/// Returns the light of coefficients at the pixels. Orders that fewer than 2 order + 1 columns or rows cannot
/// hold are left out. The function is the inverse of project_samples_of().
[[nodiscard]] EquirectImage synthesize_image(const PshVector& field, int width, int height);

}  // namespace nicol
