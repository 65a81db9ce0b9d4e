// SPDX-License-Identifier: MIT
// Smooth normals up to hard edges.
#pragma once

#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {

/// Gives every corner of triangles a normal: the faces around its position, up to edges where they meet at
/// more than `degrees` or that a surface ends at, weighted by their angle there. Where more than two
/// triangles meet at an edge, or surfaces touch in a point, each surface is smooth on its own.
void add_crease_normals(PolygonMesh& triangles, double degrees);

}  // namespace nicol::geometry
