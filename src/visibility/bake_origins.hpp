// SPDX-License-Identifier: MIT
// Where the rays of a bake start.
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/bake.hpp"

namespace nicol {

/// A point beside each vertex that is safely outside its own triangles: shifted by some 30 units in the last
/// place of the largest coordinate around, along the unit normal, and by as much in the tangent plane towards
/// the middle of the vertex's triangles. The first keeps a convex surface out of its own way: nothing of it
/// lies above the plane of a vertex. The second keeps a vertex at the foot of a wall on its side of the wall.
[[nodiscard]] std::vector<glm::vec3> bake_origins(const BakeGeometry& geometry,
                                                  std::span<const glm::vec3> unit_normals);

}  // namespace nicol
