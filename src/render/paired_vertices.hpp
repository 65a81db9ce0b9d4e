// SPDX-License-Identifier: MIT
// Vertices that two refinements of the same surfaces have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "surfaces/geometry.hpp"
#include "surfaces/refined_surfaces.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// A refinement of some given vertices.
struct RefinedVertices {
    const WorldGeometry* geometry;  ///< not used if nothing was added
    const VertexNumbers& numbers;
    std::size_t added;
    const Visibility& visibility;
};

/// Returns, for each vertex of a refinement, the same vertex of an earlier one, or kNoVertex. Added vertices
/// are paired by position, normal and visibility. given: number of vertices before refinement, of both.
[[nodiscard]] std::vector<std::uint32_t> paired_vertices(std::size_t given, const RefinedVertices& before,
                                                         const RefinedVertices& now);

}  // namespace nicol
