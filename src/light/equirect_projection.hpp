// SPDX-License-Identifier: MIT
// PSH coefficients of an equirectangular picture.
#pragma once

#include <span>

#include "nicol/psh.hpp"

namespace nicol {

/// Pixels [channel][row][column][components] in the layout and frames of EquirectImage; components is 1 (s0
/// alone) or 4. width, height >= 2.
struct EquirectPixels {
    int width;
    int height;
    int channels;
    int components;
    std::span<const float> values;
};

/// Coefficients over propagation directions in the world's axes of the function that is bilinear between
/// these pixels: not of the pixels as points, so that light and background agree at any resolution.
[[nodiscard]] PshVector project_equirect(const EquirectPixels& pixels, int order);

}  // namespace nicol
