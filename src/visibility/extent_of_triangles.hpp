// SPDX-License-Identifier: MIT
// Extent of a part of a mesh.
#pragma once

#include <cstdint>
#include <functional>

#include "geometry/edge_bisection.hpp"

namespace nicol {

using IsVertex = std::function<bool(std::uint32_t vertex)>;

/// Returns the square root of the area of the triangles with a vertex for which `counts` is true. Triangles
/// that are there twice count once. known: vertices for which `counts` is known; as large a part of the
/// triangles without such a vertex is taken to count. Empty: all.
[[nodiscard]] double extent_of_triangles(const EdgeBisection& mesh, const IsVertex& counts,
                                         const IsVertex& known = {});

}  // namespace nicol
