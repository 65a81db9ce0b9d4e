// SPDX-License-Identifier: MIT
// Triangles that an image may show.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "scene/projection.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns whether a place is in an image.
[[nodiscard]] inline bool in_view(const Projection& projection, const glm::vec3& place) {
    const glm::dvec4 p = projection.world_to_clip * glm::dvec4(place, 1);
    return std::max({std::abs(p.x), std::abs(p.y), p.z}) <= p.w && p.z >= 0;
}

/// Calls use(index, solid_angle) for triangles that face the viewer, whether they are in view or not, and
/// whether others hide them or not. Of a mesh with many triangles, about a thousand are examined.
template <class Use>
void for_seen_triangles(const WorldGeometry& geometry, const Viewpoint& view, const Use& use) {
    constexpr std::size_t most = 1024;
    const std::size_t step = (geometry.triangles.size() + most - 1) / most;
    for (std::size_t i = 0; i < geometry.triangles.size(); i += step) {
        const glm::uvec3& triangle = geometry.triangles[i];
        const glm::vec3& a = geometry.positions[triangle.x];
        const glm::vec3 area =
            glm::cross(geometry.positions[triangle.y] - a, geometry.positions[triangle.z] - a) * 0.5F;
        double solid_angle = glm::dot(glm::dvec3(area), view.towards(glm::dvec3(a)));
        if (!(solid_angle > 0)) continue;
        if (!view.orthographic) {
            const glm::dvec3 away = glm::dvec3(a) - view.eye;
            solid_angle = std::min(solid_angle / glm::dot(away, away), 4.0);
        }
        use(i, solid_angle);
    }
}

}  // namespace nicol
