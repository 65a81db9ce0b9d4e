// SPDX-License-Identifier: MIT
// PNG files for tests.
#pragma once

#include <png.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Returns a PNG file of 8-bit samples, rows from the top, with 1 (grey), 2 (with coverage), 3 or 4 channels.
inline std::string png_bytes(unsigned int width, unsigned int height, unsigned int channels,
                             const std::vector<std::uint8_t>& samples) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    constexpr std::array<png_uint_32, 4> formats{PNG_FORMAT_GRAY, PNG_FORMAT_GA, PNG_FORMAT_RGB,
                                                 PNG_FORMAT_RGBA};
    image.format = formats.at(channels - 1);
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&image, nullptr, &size, 0, samples.data(), 0, nullptr);
    std::string bytes(size, '\0');
    png_image_write_to_memory(&image, bytes.data(), &size, 0, samples.data(), 0, nullptr);
    return bytes;
}
