// SPDX-License-Identifier: MIT
// Positions of the samples of a pixel.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <numbers>
#include <numeric>
#include <span>
#include <vector>

#include "image/reconstruction_filter.hpp"

namespace nicol {

/// Largest number of samples that are drawn and shaded together, which are 1, 4 or 8. Any other number of
/// samples is drawn as that many images.
inline constexpr std::size_t kMostPixelSamples = 8;
inline constexpr int kMostDrawnSamples = 1024;

/// Returns the offsets of samples from the pixel's centre, in pixels, right and down; empty unless there are
/// 1, 4 or 8 samples. The offsets are those of Direct3D and Vulkan: no two share a row or a column of a grid,
/// and their mean is 0.
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

/// Returns the largest number of samples that are drawn together. If the samples of an image are drawn one by
/// one, this is the number of samples of its AOVs.
[[nodiscard]] inline std::size_t samples_at_once(int samples) {
    const std::size_t together = sample_pattern(samples).size();
    return together != 0 ? together : kMostPixelSamples;
}

/// Returns whether each sample is an image of its own, which the filter weighs.
[[nodiscard]] inline bool drawn_one_by_one(int samples, const ReconstructionFilter& filter) {
    return filter.kind != ReconstructionFilter::Kind::box || sample_pattern(samples).empty();
}

/// Returns the offset of one of `samples` samples that are drawn one by one. The samples form a lattice,
/// which has one of them in each row and column of a grid, so that their mean is 0. Golden steps spread the
/// samples evenly.
[[nodiscard]] inline glm::dvec2 sample_place(int sample, int samples) {
    auto step = static_cast<int>(std::lround(samples / std::numbers::phi));
    while (std::gcd(step, samples) != 1) ++step;
    const int row = static_cast<int>(std::int64_t{step} * sample % samples);
    return {(sample + 0.5) / samples - 0.5, (row + 0.5) / samples - 0.5};
}

/// Returns the offsets of all samples of a pixel, however they are drawn.
[[nodiscard]] inline std::vector<glm::dvec2> sample_places(int samples, const ReconstructionFilter& filter) {
    const std::span<const glm::dvec2> together = sample_pattern(samples);
    if (!drawn_one_by_one(samples, filter)) return {together.begin(), together.end()};
    std::vector<glm::dvec2> places(static_cast<std::size_t>(samples));
    for (int s = 0; s < samples; ++s) places[static_cast<std::size_t>(s)] = sample_place(s, samples);
    return places;
}

}  // namespace nicol
