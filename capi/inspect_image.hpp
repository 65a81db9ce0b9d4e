// SPDX-License-Identifier: MIT
// Equirectangular images of light on their way between files.
#pragma once

#include "light/image_grid.hpp"
#include "light/image_light.hpp"

namespace nicol::capi {

/// A light rotated by a rotation, at other pixels: bilinear, or the mean over each pixel where they get
/// larger than those of `source_width` columns.
[[nodiscard]] EquirectImage resample_image(const Environment& light, const glm::dmat3& rotation,
                                           int source_width, int width, int height);

}  // namespace nicol::capi
