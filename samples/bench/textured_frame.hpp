// SPDX-License-Identifier: MIT
// What textures cost.
#pragma once

#include "options.hpp"
#include "recipe.hpp"

/// How much longer a frame takes, after a move of the camera, of a sphere on a floor whose plastic has images
/// of albedo, roughness and normals, of 1024 x 1024 texels of 8 bits, than of the same in plastic without.
struct TextureCost {
    double bilinear, mipmap;
};
TextureCost texture_cost(const Options& options, const Recipe& recipe, std::uint32_t size);
