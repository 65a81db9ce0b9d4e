// SPDX-License-Identifier: MIT
// Stokes images in memory, and their errors.
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

/// Reads `plane`, which must have four floats per pixel.
Image read_image(nicol_framebuffer framebuffer, nicol_plane plane = NICOL_PLANE_STOKES);

/// Reads the instance of each pixel; the last render must have made NICOL_AOV_INSTANCE.
std::vector<std::uint32_t> read_instances(nicol_framebuffer framebuffer, std::size_t pixels);

/// Returns means over squares of `side` pixels.
Image reduced(const Image& image, std::uint32_t side);

/// Pixels that count: 1, others: 0.
using Mask = std::vector<std::uint8_t>;

/// Returns pixels that are set together with their eight neighbours; pixels on the border are not.
Mask eroded(const Mask& mask, std::uint32_t width, std::uint32_t height);

/// One value per Stokes component, over the masked pixels and all channels, relative to the root mean square
/// of s0 of the truth.
using StokesErrors = std::array<double, 4>;

/// The truth as two images of equal quality and independent noise.
struct Truth {
    Image first;
    Image second;
    Mask mask;
    Image variance{};  ///< variance of `first`, estimated by the reference method

    /// Returns the error of an image without the noise of the truth: E[(x - a)(x - b)] is the squared error
    /// if a and b are unbiased and independent. 0 if noise makes it negative.
    [[nodiscard]] StokesErrors errors(const Image& image) const;
    /// Returns the standard deviation of the noise of one image.
    [[nodiscard]] StokesErrors noise() const;
    /// Returns the standard deviation of the noise by the variance of `first` alone, an upper bound.
    [[nodiscard]] StokesErrors estimated_noise() const;

    /// Largest errors of single values, relative to the root mean square of s0. The truth is the mean of both
    /// images, so its noise is part of the errors.
    struct Tail {
        double percentile_95 = 0;
        double percentile_99 = 0;
        double largest = 0;
    };
    struct Tails {
        Tail s0;
        Tail linear;  ///< tail of the vector (s1, s2)
    };
    [[nodiscard]] Tails tails(const Image& image) const;

    /// Errors of linear polarization over the masked pixels and all channels. The truth is the mean of both
    /// images.
    struct PolarizationError {
        double dolp = 0;           ///< absolute mean of the degree's error
        double dolp_by_light = 0;  ///< mean weighted by the true s0, so that dark pixels count little
        double aolp = 0;      ///< mean of the angle's error weighted by polarized light, degrees, 0 to 90
        double streaks = 0;   ///< fraction with a degree more than 0.1 above the largest true one
        double negative = 0;  ///< fraction with s0 < 0
    };
    [[nodiscard]] PolarizationError polarization_error(const Image& image) const;

private:
    [[nodiscard]] double mean_at(std::size_t value) const {
        return (double{first.stokes[value]} + double{second.stokes[value]}) / 2;
    }
};
