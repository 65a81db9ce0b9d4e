// SPDX-License-Identifier: MIT
// Images as lights.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <span>

/// Returns the description of an image whose pixels are [row][column][channel][component]. It refers to them.
inline nicol_image light_image(std::span<const float> pixels, std::uint32_t width, std::uint32_t height,
                               std::uint32_t channels, std::uint32_t components) {
    nicol_image image = NICOL_IMAGE_INIT;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.components = components;
    image.pixels = pixels.data();
    image.byte_size = pixels.size_bytes();
    return image;
}
