// SPDX-License-Identifier: MIT
// Which points the pixels of an image show, on threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "render/executor.hpp"

namespace nicol {

/// A pixel, or the part of it that shows one surface.
struct PixelPoint {
    std::uint32_t range;     ///< number of one of the geometry's
    std::uint32_t occluded;  ///< 1 where a corner of the triangle is
    std::uint32_t triangle;
    std::uint32_t pixel;  ///< row by row
    float weight;         ///< the fraction of the pixel's samples
    glm::vec2 at;         ///< their mean from the pixel's centre, in pixels

    /// Points of one group are shaded alike.
    [[nodiscard]] std::uint64_t group() const { return std::uint64_t{2} * range + occluded; }
};

/// The points of pixels first <= i < last, those of a group side by side; and into coverage[i - first] the
/// fraction of the samples that show a surface, from its back as well. Samples of triangles that share a
/// corner are of one smooth surface, which has one point, at their mean. The input's hits are on the host.
void list_points(const PixelInput& input, std::size_t first, std::size_t last, std::vector<PixelPoint>& out,
                 std::span<float> coverage);

}  // namespace nicol
