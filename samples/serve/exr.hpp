// SPDX-License-Identifier: MIT
// Images as OpenEXR in memory: 32-bit floats, not compressed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

/// data is [row][column][channel]; names of channels differ and are in the order of their bytes, as the
/// format wants.
std::string encode_exr(std::uint32_t width, std::uint32_t height, const std::vector<std::string>& names,
                       const std::vector<float>& data);
