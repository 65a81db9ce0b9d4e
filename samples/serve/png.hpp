// SPDX-License-Identifier: MIT
// Images as PNG in memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// 8-bit R G B, [row][column][3]; quick rather than small. `srgb` says that the numbers follow the sRGB
/// curve. Throws Failure.
std::string encode_png(std::uint32_t width, std::uint32_t height, const std::vector<std::uint8_t>& rgb,
                       bool srgb);
