// SPDX-License-Identifier: MIT
// Between coefficients and the samples of a field at the pixels of an equirectangular image.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// Coefficients of the light without orders above `order` whose samples the pixels are. Throws
/// Error(invalid_argument) for fewer than 2 order + 1 columns or rows.
[[nodiscard]] PshVector project_samples_of(const EquirectImage& image, int order);

/// The light of coefficients at the pixels; orders that fewer than 2 order + 1 columns or rows cannot hold
/// are left out. The inverse of project_samples_of().
[[nodiscard]] EquirectImage synthesize_image(const PshVector& field, int width, int height);

}  // namespace nicol
