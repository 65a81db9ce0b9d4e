// SPDX-License-Identifier: MIT
// Observers of Stokes images: values, and colours as in nicol_framebuffer_write_png.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <vector>

#include "image_request.hpp"

/// An image of several floats per pixel, [row][column][value].
struct FloatImage {
    std::uint32_t width = 0, height = 0, values = 0;
    std::vector<float> data;
};

/// Returns observed values, one per colour channel. dolp and aolp (radians) have one value, of the channels'
/// mean. s0 and polarizer are multiplied by 2^exposure.
FloatImage observe(nicol_framebuffer framebuffer, const ImageRequest& request);

/// Returns 8-bit R G B: s0 and polarizer (one channel or three) with the sRGB curve; s1, s2, s3 (mean of
/// their channels) red below and green above 0; dolp grey; aolp (two values: angle and DoLP) as hue. A
/// `scale` of 0 is replaced by the value at full colour.
std::vector<std::uint8_t> colours(const FloatImage& image, Observer observer, float& scale);
