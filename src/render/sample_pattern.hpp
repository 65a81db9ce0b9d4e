// SPDX-License-Identifier: MIT
// Where the samples of a pixel are.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

namespace nicol {

/// That are drawn and shaded together: 1, 4 or 8. Any other number is drawn as that many images.
inline constexpr std::size_t kMostPixelSamples = 8;
inline constexpr int kMostDrawnSamples = 1024;

/// Offsets from the pixel's centre in pixels, right and down; empty unless there are 1, 4 or 8 samples. They
/// are those of Direct3D and Vulkan: no two share a row or a column of a grid, and their mean is 0.
[[nodiscard]] inline std::span<const glm::dvec2> sample_pattern(int samples) {
    static constexpr std::array<glm::dvec2, 1> one{{{0, 0}}};
    static constexpr std::array<glm::dvec2, 4> four{
        {{-0.125, -0.375}, {0.375, -0.125}, {-0.375, 0.125}, {0.125, 0.375}}};
    static constexpr std::array<glm::dvec2, kMostPixelSamples> eight{{{0.0625, -0.1875},
                                                                      {-0.0625, 0.1875},
                                                                      {0.3125, 0.0625},
                                                                      {-0.1875, -0.3125},
                                                                      {-0.3125, 0.3125},
                                                                      {-0.4375, -0.0625},
                                                                      {0.1875, 0.4375},
                                                                      {0.4375, -0.4375}}};
    switch (samples) {
        case 1:
            return one;
        case 4:
            return four;
        case 8:
            return eight;
        default:
            return {};
    }
}

/// How many of so many are drawn together at most; where the others are drawn one by one, it is AOVs that
/// are.
[[nodiscard]] inline std::size_t samples_at_once(int samples) {
    const std::size_t together = sample_pattern(samples).size();
    return together != 0 ? together : kMostPixelSamples;
}

/// Of samples that are drawn one by one, the offset of one: Roberts' additive sequence, which fills the pixel
/// evenly after any number of them.
[[nodiscard]] inline glm::dvec2 sample_place(int sample) {
    // 1 / p and 1 / p^2, where p^3 = p + 1.
    constexpr double x = 0.7548776662466927;
    constexpr double y = 0.5698402909980532;
    const double n = sample;
    return {n * x - std::round(n * x), n * y - std::round(n * y)};
}

}  // namespace nicol
