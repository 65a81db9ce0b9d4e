// SPDX-License-Identifier: MIT
// Largest coordinates of points, and the limit of those of surfaces.
#pragma once

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>

namespace nicol {

/// Largest absolute coordinate of a vertex. The limit exists because Embree multiplies coordinates in single
/// precision.
inline constexpr float kLargestCoordinate = 1e15F;

/// Returns the largest absolute coordinate of a point.
template <class Number>
[[nodiscard]] Number largest_coordinate(const glm::vec<3, Number>& point) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

}  // namespace nicol
