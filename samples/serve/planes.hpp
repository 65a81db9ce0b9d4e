// SPDX-License-Identifier: MIT
// Stokes images laid out so that they compress well, without loss.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

struct Planes {
    std::uint32_t components = 4;  ///< 3 where s3 is zero everywhere, and left out
    /// [component][channel][byte: low, high][row][column]: of each 16-bit number its difference to the one to
    /// its left, modulo 65536.
    std::string bytes;
};

/// halves: little-endian, [channel][row][column][4], as many channels as there are.
Planes planes_of(std::string_view halves, std::uint32_t width, std::uint32_t height);
