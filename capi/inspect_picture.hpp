// SPDX-License-Identifier: MIT
// Equirectangular pictures of light on their way between files.
#pragma once

#include "light/picture_grid.hpp"
#include "light/picture_light.hpp"

namespace nicol::capi {

/// A light turned by a rotation, at other pixels: bilinear, or the mean over each pixel where they get larger
/// than those of `source_width` columns.
[[nodiscard]] EquirectImage resample_picture(const Environment& light, const glm::dmat3& rotation,
                                             int source_width, int width, int height);

}  // namespace nicol::capi
