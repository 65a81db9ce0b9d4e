// SPDX-License-Identifier: MIT
// Stokes images in memory, and their errors.
#pragma once

#include <nicol.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

struct Image {
    std::size_t size = 0;                      ///< width and height, in pixels
    std::array<std::vector<float>, 3> stokes;  ///< by colour channel: [row][column][4]
    std::vector<std::uint8_t> object;          ///< 1 if a pixel shows an object, 0 if it shows the light
};

/// Reads a framebuffer with three channels and equally many rows and columns; `object` stays empty.
Image read_image(nicol_framebuffer framebuffer);

/// Shares of an object's pixels in which some channel leaves the physically realizable range (Eq. 70).
struct RealizableRange {
    double negative = 0;       ///< s0 < 0
    double overpolarized = 0;  ///< s0 >= 0 and more polarization than light
};
RealizableRange realizable_range(const Image& image);

/// Violation of Eq. 70 in some channel of a pixel, beyond the rounding of light of about 1.
enum class Fault { none, negative, overpolarized };
Fault fault_at(const Image& image, std::size_t pixel);

/// Returns pixels that are set together with their eight neighbours; pixels on the border are not.
std::vector<std::uint8_t> eroded(const std::vector<std::uint8_t>& mask, std::size_t size);

/// Returns errors of s0, s1 and s2: root mean square over the masked pixels and all channels, relative to
/// that of s0 of the truth. The truth is two images a and b of independent noise: E[(x - a)(x - b)] is the
/// squared error without the noise. 0 if noise makes it negative.
std::array<double, 3> relative_errors(const Image& image, const std::array<Image, 2>& truth,
                                      const std::vector<std::uint8_t>& mask);
