// SPDX-License-Identifier: MIT
// Equirectangular images of light at other pixels.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// A rotated light as an image: bilinear look-ups, or their mean over each pixel where the pixels are larger
/// than those of `source_width` columns.
[[nodiscard]] EquirectImage resample_image(const Environment& light, const glm::dmat3& rotation,
                                           int source_width, int width, int height);

}  // namespace nicol
