// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "sheet.hpp"

namespace {

using Colour = std::array<double, 3>;  // linear RGB, 0 to 1

constexpr Colour kNoObject = {0.04, 0.04, 0.04};

std::uint8_t srgb(double linear) {
    const double x = std::clamp(linear, 0.0, 1.0);
    const double curve = x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255 * curve));
}

// Returns means over pixels of colour_at(pixel) at objects and grey elsewhere, encoded by the sRGB curve.
template <class ColourAt>
Panel shrunk(const Image& image, std::size_t size, ColourAt colour_at) {
    const std::vector<std::uint8_t>& mask = image.object;
    const std::size_t side = std::max<std::size_t>(image.size / size, 1);
    Panel panel{.size = image.size / side, .rgb = {}};
    for (std::size_t y = 0; y < panel.size; ++y) {
        for (std::size_t x = 0; x < panel.size; ++x) {
            Colour sum{};
            for (std::size_t v = y * side; v < (y + 1) * side; ++v) {
                for (std::size_t u = x * side; u < (x + 1) * side; ++u) {
                    const std::size_t i = v * image.size + u;
                    const Colour colour = mask[i] != 0 ? colour_at(i) : kNoObject;
                    for (std::size_t c = 0; c < 3; ++c) sum[c] += std::clamp(colour[c], 0.0, 1.0);
                }
            }
            for (const double value : sum)
                panel.rgb.push_back(srgb(value / static_cast<double>(side * side)));
        }
    }
    return panel;
}

double mean_of_channels(const Image& image, std::size_t pixel, std::size_t p) {
    double sum = 0;
    for (const auto& plane : image.stokes) sum += double{plane[4 * pixel + p]};
    return sum / 3;
}

// Returns the value that this share of the values does not exceed.
double percentile(std::vector<double> values, double share) {
    if (values.empty()) return 1;
    const auto place = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + place, values.end());
    return std::max(values[static_cast<std::size_t>(place)], 1e-12);
}

}  // namespace

Exposure expose(const Image& image) {
    const std::vector<std::uint8_t>& mask = image.object;
    std::vector<double> light, polarized;
    for (std::size_t i = 0; i < mask.size(); ++i) {
        if (mask[i] == 0) continue;
        light.push_back(std::max({image.stokes[0][4 * i], image.stokes[1][4 * i], image.stokes[2][4 * i]}));
        for (const std::size_t p : {1u, 2u}) polarized.push_back(std::abs(mean_of_channels(image, i, p)));
    }
    return {.s0 = percentile(std::move(light), 0.98), .polarized = percentile(std::move(polarized), 0.99)};
}

Panel Colouring::s0(const Image& image) const {
    return shrunk(image, size_, [&](std::size_t i) {
        Colour colour;
        for (std::size_t c = 0; c < 3; ++c) colour[c] = double{image.stokes[c][4 * i]} / exposure_.s0;
        return colour;
    });
}

Panel Colouring::polarized(const Image& image, std::size_t p) const {
    return shrunk(image, size_, [&](std::size_t i) {
        const double value = mean_of_channels(image, i, p) / exposure_.polarized;
        return Colour{-value, value, 0};
    });
}

Panel Colouring::unphysical(const Image& image) const {
    return shrunk(image, size_, [&](std::size_t i) {
        const Fault fault = fault_at(image, i);
        if (fault == Fault::negative) return Colour{0.8, 0.05, 0.02};
        if (fault == Fault::overpolarized) return Colour{0.85, 0.6, 0.05};
        const double dim = 0.25 * std::max(mean_of_channels(image, i, 0), 0.0) / exposure_.s0;
        return Colour{dim, dim, dim};
    });
}
