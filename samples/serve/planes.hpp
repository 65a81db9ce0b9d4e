// SPDX-License-Identifier: MIT
// Stokes images laid out so that they compress well, with or without loss.
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

/// halves: little-endian, [channel][row][column][4], as many channels as there are. bits 1 to 10: each vector
/// is rounded to multiples of 2^-bits times the power of two at or below its |s0|; 0: not at all.
Planes planes_of(std::string_view halves, std::uint32_t width, std::uint32_t height, std::uint32_t bits);
