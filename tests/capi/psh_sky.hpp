// SPDX-License-Identifier: MIT
// A clear sky as a formula, to compare light with.
#pragma once

#include "psh.hpp"

namespace capi_test {

inline const Vec3 sun = unit({0.5, 0.7, -0.2});
inline constexpr double dop_max = 0.8;

/// Radiance of single scattering that propagates along w, in a frame with this x axis at right angles to w.
inline std::array<double, 4> sky_light(const Vec3& w, const Vec3& x) {
    const double c = -dot(w, sun);
    const double polarized = 0.75 * dop_max * (1 - c * c);
    const Vec3 field = cross(sun, w);  // the electric field, of any sign
    const double angle = std::atan2(dot(field, cross(w, x)), dot(field, x));
    return {0.75 * (1 + c * c), polarized * std::cos(2 * angle), polarized * std::sin(2 * angle), 0};
}

/// Largest difference between a field of order 2 or more and the sky.
inline double difference_from_sky(std::uint32_t order, const double* field) {
    std::mt19937 random(9);
    double largest = 0;
    for (int trial = 0; trial < 50; ++trial) {
        const Vec3 w = random_direction(random);
        const auto wanted = sky_light(w, theta_phi(w)[0]);
        const auto s = value(order, field, w);
        for (std::size_t p = 0; p < 4; ++p) largest = std::max(largest, std::abs(s[p] - wanted[p]));
    }
    return largest;
}

/// The sky as an image [row][column][channel][4], each channel a multiple: 1, 2, ...
inline std::vector<float> sky_image(std::uint32_t width, std::uint32_t height, std::uint32_t channels) {
    std::vector<float> pixels;
    for (std::uint32_t row = 0; row < height; ++row)
        for (std::uint32_t column = 0; column < width; ++column) {
            const double u = 2 * pi * (column + 0.5) / width, v = pi * row / (height - 1);
            const Vec3 towards = {std::sin(u) * std::sin(v), std::cos(v), -std::cos(u) * std::sin(v)};
            const auto s = sky_light({-towards[0], -towards[1], -towards[2]}, {std::cos(u), 0, std::sin(u)});
            for (std::uint32_t c = 1; c <= channels; ++c)
                for (const double x : s) pixels.push_back(static_cast<float>(c * x));
        }
    return pixels;
}

inline nicol_image image_of(const std::vector<float>& pixels, std::uint32_t width, std::uint32_t height,
                            std::uint32_t channels, std::uint32_t components = 4) {
    nicol_image image = NICOL_IMAGE_INIT;
    image.width = width;
    image.height = height;
    image.channels = channels;
    image.components = components;
    image.pixels = pixels.data();
    image.byte_size = pixels.size() * sizeof(float);
    return image;
}

}  // namespace capi_test
