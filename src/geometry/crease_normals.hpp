// SPDX-License-Identifier: MIT
// Vertex normals that are smooth up to hard edges, by the half-edges of OpenMesh. The rest of this folder
// needs no neighbours of faces, or, as EdgeBisection does, keeps faces at edges of more than two, which
// OpenMesh rejects and files have; making half-edges alone takes five times as long as making an
// EdgeBisection (a million triangles).
#pragma once

#include "files/load_budget.hpp"
#include "geometry/polygon_mesh.hpp"

namespace nicol::geometry {

/// Gives every corner of triangles a normal: the mean of the faces around its position, weighted by their
/// angle there. The mean ends at boundary edges and at edges whose faces meet at more than `degrees`.
/// Surfaces that touch in a point are smoothed separately. Triangles beyond the first two at an edge end
/// there. If more than 512 triangles meet at a position, neighbours in the file are smoothed together. Time:
/// linear.
void add_crease_normals(PolygonMesh& triangles, double degrees, const LoadBudget& budget);

}  // namespace nicol::geometry
