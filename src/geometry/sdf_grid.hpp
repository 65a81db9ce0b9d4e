// SPDX-License-Identifier: MIT
// Surfaces of grids of signed distances.
#pragma once

#include <filesystem>

#include "files/load_budget.hpp"
#include "geometry/mesh.hpp"

namespace nicol {

/// Normals of the surface of a grid of distances.
enum class SdfNormals {
    smooth,   ///< continuous: a blend of the gradients of nearby cells
    analytic  ///< the gradient of the interpolation, which jumps from cell to cell
};

/// Reads a grid of signed distances, a volume of one channel in Mitsuba's format that fills the cube 0..1, as
/// the surface where their trilinear interpolation is 0. The front is where distances are positive. Vertices
/// lie on that surface as far as a few steps of Newton's method find it; edges are about as long as the
/// grid's cells. There are no texture coordinates. Throws Error(invalid_file) or Error(unsupported) that says
/// what is wrong, and what read_bytes() and the budget throw.
[[nodiscard]] Mesh load_sdf_grid(const std::filesystem::path& file, SdfNormals normals = SdfNormals::smooth,
                                 const LoadBudget& budget = {});

}  // namespace nicol
