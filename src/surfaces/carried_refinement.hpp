// SPDX-License-Identifier: MIT
// A refinement that follows a change of the surfaces until it is made anew.
#pragma once

#include <cstdint>
#include <vector>

#include "surfaces/scene_geometry.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// Refinement of changed surfaces, with neither visibility nor points.
struct CarriedRefinement {
    Refinement refinement;  ///< without parents: nothing is refined
    /// For each vertex, given or added, the index of the same vertex in the former refinement, or kNoVertex.
    std::vector<std::uint32_t> former;
    /// For each vertex, the index of its run in Change::moved, or kNoVertex.
    std::vector<std::uint32_t> moved;
};

/// Returns the refinement `before`, whose first `given` vertices were given, for the current surfaces:
/// triangles of kept and moved instances stay divided as they were, other triangles are whole.
[[nodiscard]] CarriedRefinement carried(const Refinement& before, std::size_t given,
                                        const SceneGeometry& surfaces);

}  // namespace nicol
