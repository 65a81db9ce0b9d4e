// SPDX-License-Identifier: MIT
// Extent of a part of a mesh.
#pragma once

#include <cstdint>
#include <functional>

#include "geometry/edge_bisection.hpp"

namespace nicol {

/// Returns the square root of the area of the triangles with a vertex for which `counts` is true. Triangles
/// that are there twice count once.
[[nodiscard]] double extent_of_triangles(const EdgeBisection& mesh,
                                         const std::function<bool(std::uint32_t vertex)>& counts);

}  // namespace nicol
