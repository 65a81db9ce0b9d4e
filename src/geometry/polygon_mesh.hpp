// SPDX-License-Identifier: MIT
// Polygons as OpenMesh's readers deliver them, and their triangulation.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/mesh.hpp"
#include "geometry/parse.hpp"

namespace nicol::geometry {

/// Polygons that share positions and nothing else. Unlike a half-edge mesh it holds non-manifold faces too.
struct PolygonMesh {
    struct Corner {
        std::uint32_t position;
        glm::vec3 normal;  ///< zero where the file gives none
    };
    std::vector<glm::vec3> positions;
    std::vector<Corner> corners;
    std::vector<std::size_t> face_ends;  ///< face f has the corners [face_ends[f - 1], face_ends[f])
};

/// Runs OpenMesh's reader over a parsed file. Thread-safe. Throws Error(internal) with OpenMesh's message if
/// the reader fails all the same.
[[nodiscard]] PolygonMesh read_polygons(std::string_view name, const ParsedFile& file);

/// Averages the normals of faces at each position as long as they are less than `degrees` apart.
void smooth_within_crease(PolygonMesh& polygons, double degrees);

/// Triangulates polygons and splits positions whose corners have different normals. `faces` receives the face
/// of each triangle.
[[nodiscard]] Mesh triangulated(const PolygonMesh& polygons, std::vector<std::uint32_t>& faces);

/// As nicol::validate(). Messages name faces[t] in place of triangle t; empty `faces`: the triangle itself.
void validate(Mesh& mesh, std::string_view name, std::span<const std::uint32_t> faces);

/// As nicol::load_mesh() of a file that has this name and holds these bytes.
[[nodiscard]] Mesh mesh_of(const std::filesystem::path& file, std::string_view bytes);

}  // namespace nicol::geometry
