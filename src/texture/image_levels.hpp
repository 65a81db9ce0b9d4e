// SPDX-License-Identifier: MIT
// Mipmap levels of an image.
#pragma once

#include <vector>

#include "texture/texture.hpp"

namespace nicol {

/// Returns the image and then each level half the size of the level before, rounded down, to 1 x 1. A texel
/// is the mean of the area it covers, so that every level has the mean of the image.
[[nodiscard]] std::vector<TextureImage> image_levels(TextureImage image);

/// Returns the gradient by the values of an image of width x height from the gradients by the values of all
/// of its levels, each [row][column][channel]: the transpose of image_levels().
[[nodiscard]] std::vector<double> gradient_by_image(std::vector<std::vector<double>> levels, int width,
                                                    int height);

}  // namespace nicol
