// SPDX-License-Identifier: MIT
// Stokes images in a layout that compresses well, with or without loss.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

struct Planes {
    std::uint32_t components = 4;  ///< 3 if s3 is zero everywhere and left out
    /// Planes [component][channel][byte: low, high][row][column]: for each 16-bit number its difference to
    /// its left neighbour, modulo 65536.
    std::string bytes;
};

/// Returns planes. halves: little-endian, [channel][row][column][4], any number of channels. bits 1 to 10:
/// each vector is rounded to multiples of 2^-bits times the power of two at or below its |s0|; 0: not
/// rounded.
Planes planes_of(std::string_view halves, std::uint32_t width, std::uint32_t height, std::uint32_t bits);
