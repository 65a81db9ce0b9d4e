// SPDX-License-Identifier: MIT
// The directions that anisotropic materials follow.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "surfaces/geometry.hpp"

namespace nicol {

/// Where texture coordinate u grows at a point of a triangle, across the interpolated normal there: unit, or
/// 0 where it does not grow. `weights`: barycentric. The geometry has texture coordinates.
[[nodiscard]] glm::vec3 tangent(const WorldGeometry& geometry, std::uint32_t triangle,
                                const glm::vec3& weights);

/// By vertex the mean over its triangles, unit or 0. Empty where no material is anisotropic.
[[nodiscard]] std::vector<glm::vec3> vertex_tangents(const WorldGeometry& geometry);

}  // namespace nicol
