// SPDX-License-Identifier: MIT
// Points so close to each other that an image shows them in about one pixel.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/key_table.hpp"

namespace nicol {

/// Points by cells as large as a pixel. Points of one cell face about the same way.
class PointsInPixels {
public:
    /// pixel: side of a pixel at the points. 0: each point has a cell of its own.
    explicit PointsInPixels(double pixel) : pixel_(static_cast<float>(pixel)) {}

    /// Adds a point with a unit normal. Returns the number of the point that was added first of its cell:
    /// `number` if that is this point.
    std::uint32_t add(const glm::vec3& position, const glm::vec3& normal, std::uint32_t number);

private:
    float pixel_;
    // Numbers by the hash of a cell. Points of different cells with one hash are taken for close ones.
    KeyTable<std::uint32_t> first_;
};

}  // namespace nicol
