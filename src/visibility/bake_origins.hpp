// SPDX-License-Identifier: MIT
// Start points of the rays of a bake.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/bake.hpp"

namespace nicol {

/// Returns, for each vertex, a point that is safely outside its own triangles. The point is shifted by about
/// 30 units in the last place of the largest coordinate around, along the unit normal and also in the tangent
/// plane towards the middle of the vertex's triangles. The first shift keeps a convex surface from shadowing
/// itself, because nothing of it lies above the tangent plane of a vertex. The second shift keeps a vertex at
/// the foot of a wall on its side of the wall.
[[nodiscard]] std::vector<glm::vec3> bake_origins(const BakeGeometry& geometry,
                                                  std::span<const glm::vec3> unit_normals);

}  // namespace nicol
