// SPDX-License-Identifier: MIT
// Computation of normals from triangles.
#pragma once

#include <cstddef>

#include "geometry/mesh.hpp"

namespace nicol::geometry {

/// Removes triangles without area: two corners that share a vertex or a position, or three on one line.
/// Returns the number of removed triangles. Positions must be finite.
std::size_t remove_flat_triangles(Mesh& mesh);

/// Gives every normal unit length. A normal of zero length is replaced by the smooth normal, or by +z if the
/// vertex has no face.
void complete_normals(Mesh& mesh);

}  // namespace nicol::geometry
