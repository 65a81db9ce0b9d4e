// SPDX-License-Identifier: MIT
// Images as PNG in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Encodes 8-bit R G B, [row][column][3], quickly rather than compactly. `srgb` states that the numbers
/// follow the sRGB curve. Throws Failure.
std::string encode_png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgb,
                       bool srgb);
