// SPDX-License-Identifier: MIT
// Tangents: the directions that anisotropic materials follow.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns the direction of growing texture coordinate u at a point of a triangle, perpendicular to the
/// interpolated normal: unit, or 0 if u does not grow. weights: barycentric weights of the point. The
/// geometry must have texture coordinates.
[[nodiscard]] glm::vec3 tangent(const WorldGeometry& geometry, std::uint32_t triangle,
                                const glm::vec3& weights);

/// Returns, for each vertex, the mean direction of growing u over its triangles, unit or 0. Empty if no
/// material is anisotropic.
[[nodiscard]] std::vector<glm::vec3> vertex_tangents(const WorldGeometry& geometry);

}  // namespace nicol
