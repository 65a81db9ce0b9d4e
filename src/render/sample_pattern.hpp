// SPDX-License-Identifier: MIT
// Where the samples of a pixel are.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <span>

namespace nicol {

inline constexpr std::size_t kMostPixelSamples = 8;

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

}  // namespace nicol
