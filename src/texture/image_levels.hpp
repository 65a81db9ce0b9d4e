// SPDX-License-Identifier: MIT
// An image in ever smaller sizes (mipmap).
#pragma once

#include <vector>

#include "texture/texture.hpp"

namespace nicol {

/// The image, and then each level half the size of the one before, rounded down, to 1 x 1. A texel is the
/// mean of what it covers, so that every level has the mean of the image.
[[nodiscard]] std::vector<TextureImage> image_levels(TextureImage image);

}  // namespace nicol
