// SPDX-License-Identifier: MIT
// Smooth normals up to hard edges.
#pragma once

#include "files/load_budget.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {

/// Gives every corner of triangles a normal: the faces around its position, up to edges where they meet at
/// more than `degrees` or that a surface ends at, weighted by their angle there. Surfaces that touch in a
/// point are smooth each on its own, and triangles beyond the first two at an edge end there. Of more than
/// 512 triangles at a position, those that come together in the file are smooth together. Time: linear.
void add_crease_normals(PolygonMesh& triangles, double degrees, const LoadBudget& budget);

}  // namespace nicol::geometry
