// SPDX-License-Identifier: MIT
// Observers of Stokes images: values, and colours like those of nicol_framebuffer_write_png.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <vector>

#include "image_request.hpp"

/// An image of some floats a pixel, [row][column][value].
struct FloatImage {
    std::uint32_t width = 0, height = 0, values = 0;
    std::vector<float> data;
};

/// The observed values, one per colour channel; dolp and aolp (radians) are of the channels' mean and have
/// one. s0 and polarizer are times 2^exposure.
FloatImage observe(nicol_framebuffer framebuffer, const ImageRequest& request);

/// 8-bit R G B: s0 and polarizer (one channel or three) with the sRGB curve; s1, s2, s3 (their channels'
/// mean) red below and green above 0; dolp grey; aolp (two values: angle and DoLP) as hue. `scale` becomes
/// the value at full colour, where it was 0.
std::vector<std::uint8_t> colours(const FloatImage& image, Observer observer, float& scale);
