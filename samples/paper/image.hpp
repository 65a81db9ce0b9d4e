// SPDX-License-Identifier: MIT
// Stokes images in memory, and how far one is from another.
#pragma once

#include <nicol.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

struct Image {
    std::size_t size = 0;                      ///< of both sides, in pixels
    std::array<std::vector<float>, 3> stokes;  ///< a colour channel each: [row][column][4]
    std::vector<std::uint8_t> object;  ///< 1 where a pixel shows an object, 0 where it shows the light
};

/// Of a framebuffer with three channels and as many rows as columns; `object` stays empty.
Image read_image(nicol_framebuffer framebuffer);

/// Shares of an object's pixels, where some channel leaves the physically realizable range (Eq. 70).
struct PhysicalRange {
    double negative = 0;       ///< s0 < 0
    double overpolarized = 0;  ///< else, more polarization than light
};
PhysicalRange physical_range(const Image& image);

/// What a pixel breaks of Eq. 70 in some channel, beyond the rounding of light of about 1.
enum class Fault { none, negative, overpolarized };
Fault fault_at(const Image& image, std::size_t pixel);

/// A pixel stays where it and its eight neighbours are set; pixels on the border do not.
std::vector<std::uint8_t> eroded(const std::vector<std::uint8_t>& mask, std::size_t size);

/// Of s0, s1 and s2: root mean square over the masked pixels and all channels, relative to that of s0 of the
/// truth. The truth is two images of independent noise a and b: E[(x - a)(x - b)] is the squared error
/// without it. 0 where noise makes it negative.
std::array<double, 3> relative_errors(const Image& image, const std::array<Image, 2>& truth,
                                      const std::vector<std::uint8_t>& mask);
