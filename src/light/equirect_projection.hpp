// SPDX-License-Identifier: MIT
// Between equirectangular images and PSH coefficients.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// Coefficients over propagation directions in the world's axes of the function that is bilinear between
/// these pixels, at least 2 x 2: not of the pixels as points, so that light and background agree at any
/// resolution.
[[nodiscard]] PshVector project_equirect(const EquirectView& view, int order);

/// Coefficients of the light without orders above `order` whose samples the pixels are. Throws
/// Error(invalid_argument) for fewer than 2 order + 1 columns or rows.
[[nodiscard]] PshVector project_samples_of(const EquirectImage& image, int order);

/// The light of coefficients at the pixels; orders that fewer than 2 order + 1 columns or rows cannot hold
/// are left out. The inverse of project_samples_of().
[[nodiscard]] EquirectImage synthesize_image(const PshVector& field, int width, int height);

}  // namespace nicol
