// SPDX-License-Identifier: MIT
// Normals from triangles.
#pragma once

#include <cstddef>

#include "geometry/mesh.hpp"

namespace nicol::geometry {

/// Removes triangles without area: two corners that share a vertex or a position, or three on one line.
/// Returns how many. Positions must be finite.
std::size_t remove_flat_triangles(Mesh& mesh);

/// Gives every normal unit length; one of zero length is replaced by the smooth one, +z where there is no
/// face.
void complete_normals(Mesh& mesh);

}  // namespace nicol::geometry
