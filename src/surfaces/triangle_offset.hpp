// SPDX-License-Identifier: MIT
// Distance between a triangle and rays that leave it.
#pragma once

#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns ray_offset() of a triangle.
[[nodiscard]] inline double offset_of_triangle(const WorldGeometry& geometry, std::uint32_t triangle) {
    const glm::uvec3& corners = geometry.triangles[triangle];
    return ray_offset(
        {geometry.positions[corners.x], geometry.positions[corners.y], geometry.positions[corners.z]});
}

}  // namespace nicol
