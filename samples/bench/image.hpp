// SPDX-License-Identifier: MIT
// Stokes images in memory, and how far one is from another.
#pragma once

#include <nicol.h>

#include <array>
#include <cstdint>
#include <vector>

struct Image {
    std::uint32_t width = 0;
    std::uint32_t height = 0;
    std::uint32_t channels = 0;
    std::vector<float> stokes;  ///< [channel][row][column][4]
};

/// `plane`: one of four floats a pixel.
Image read_image(nicol_framebuffer framebuffer, nicol_plane plane = NICOL_PLANE_STOKES);

/// Means over squares of `side` pixels.
Image reduced(const Image& image, std::uint32_t side);

/// 1 for each pixel that counts.
using Mask = std::vector<std::uint8_t>;

/// A pixel stays where it and its eight neighbours are set; pixels on the border do not.
Mask eroded(const Mask& mask, std::uint32_t width, std::uint32_t height);

/// One value a Stokes component, over the masked pixels and all channels, relative to the root mean square of
/// s0 of the truth.
using StokesErrors = std::array<double, 4>;

/// The truth as two images of equal quality and independent noise.
struct Truth {
    Image first;
    Image second;
    Mask mask;
    Image variance{};  ///< of the first, as the reference method estimates it

    /// Of an image, without the noise of the truth: E[(x - a)(x - b)] is the squared error where a and b are
    /// unbiased and independent. 0 where noise makes it negative.
    [[nodiscard]] StokesErrors errors(const Image& image) const;
    /// Standard deviation of the noise of one of the two.
    [[nodiscard]] StokesErrors noise() const;
    /// The same by the variance of the first alone: an upper bound.
    [[nodiscard]] StokesErrors estimated_noise() const;

    /// Of the degree of linear polarization, over the masked pixels and all channels. The truth's is of the
    /// mean of both images.
    struct DolpError {
        double mean = 0;      ///< absolute
        double streaks = 0;   ///< part that is polarized by 0.1 more than the largest true one
        double negative = 0;  ///< part with s0 < 0
    };
    [[nodiscard]] DolpError dolp_error(const Image& image) const;
};
