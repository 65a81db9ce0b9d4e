// SPDX-License-Identifier: MIT
// Images as OpenEXR in memory: uncompressed 32-bit floats.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// Encodes an image. data is [row][column][channel]; names of channels differ and are in the order of their
/// bytes, as the format requires.
std::string encode_exr(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& names,
                       const std::vector<float>& data);
