// SPDX-License-Identifier: MIT
// Triangulation of one polygon.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "files/load_budget.hpp"

namespace nicol::geometry {

/// Appends the n - 2 triangles of a polygon of three or more corners to `out`, as indices of corners, with
/// the polygon's orientation. Concave polygons and polygons with a bridge to a hole are covered once, as seen
/// along their normal. For polygons that cross themselves, only the number of triangles is guaranteed.
/// Polygons of more than 1024 corners are taken as convex. Time: at most the square of the corners.
void clip_ears(std::span<const glm::dvec3> corners, const LoadBudget& budget, std::vector<glm::uvec3>& out);

}  // namespace nicol::geometry
