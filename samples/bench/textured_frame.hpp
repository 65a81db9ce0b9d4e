// SPDX-License-Identifier: MIT
// The cost of textures.
#pragma once

#include "options.hpp"
#include "recipe.hpp"

/// Time of a frame with textures divided by that without, after a move of the camera: a sphere on a floor,
/// whose plastic has images of albedo, roughness and normals, 1024 x 1024 texels of 8 bits.
struct TextureCost {
    double bilinear, mipmap;
};
TextureCost texture_cost(const Options& options, const Recipe& recipe, std::uint32_t size);
