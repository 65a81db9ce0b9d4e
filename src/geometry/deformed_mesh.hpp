// SPDX-License-Identifier: MIT
// Meshes that differ in the places of their vertices, such as the frames of an animated character.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "geometry/mesh.hpp"

namespace nicol {

/// Returns a mesh with other positions and normals, one per vertex; triangles, texture coordinates and
/// colours are those of `mesh`. Triangles may lose their area. Normals get unit length; a normal of zero
/// length is replaced by the smooth normal, and without any all are made by smooth_normals(). Tangents are
/// left out, so that texture coordinates say where the axes of normal maps lie. Throws
/// Error(invalid_argument) naming the vertex whose position or normal is not finite, or the counts that
/// differ.
[[nodiscard]] Mesh deformed(const Mesh& mesh, std::vector<glm::vec3> positions,
                            std::vector<glm::vec3> normals);

/// Returns whether two meshes differ in the places of their vertices alone: they have the same triangles.
[[nodiscard]] bool same_triangles(const Mesh& a, const Mesh& b);

}  // namespace nicol
