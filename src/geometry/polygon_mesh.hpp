// SPDX-License-Identifier: MIT
// Polygons of a mesh file and their triangulation.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "files/load_budget.hpp"
#include "geometry/left_out.hpp"
#include "geometry/mesh.hpp"

namespace nicol::geometry {

/// Polygons that share positions and nothing else. Unlike a half-edge mesh, it holds non-manifold faces too.
struct PolygonMesh {
    static constexpr std::uint32_t kNone = 0xffffffff;
    struct Corner {
        std::uint32_t position;
        std::uint32_t normal = kNone;
        std::uint32_t texcoord = kNone;
    };
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< normals of any length; a zero normal counts as missing
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec3> colors;  ///< colours of the positions, or empty
    std::vector<Corner> corners;
    std::vector<std::size_t> face_ends;  ///< face f has the corners [face_ends[f - 1], face_ends[f])
    std::vector<glm::vec3> face_colors;  ///< colours of the faces, or empty

    /// Makes a face of the corners since the last one; drops them and counts the face in `left_out` if they
    /// are fewer than 3. Returns whether the face is kept.
    bool end_face(LeftOut& left_out) {
        const std::size_t first = face_ends.empty() ? 0 : face_ends.back();
        const bool kept = corners.size() - first >= 3;
        if (kept) {
            face_ends.push_back(corners.size());
        } else {
            left_out.add("faces of fewer than 3 corners");
            corners.resize(first);
        }
        return kept;
    }
};

/// Returns triangles of the polygons, which may be concave. Positions whose corners have different normals
/// are split. Missing normals are smooth over the faces that lack them. Vertices without a face and triangles
/// without area are left out.
[[nodiscard]] Mesh triangulated(const PolygonMesh& polygons, std::string_view name, LeftOut& left_out,
                                const LoadBudget& budget);

/// Reads a mesh as load_mesh() does, from a file's name and its bytes.
[[nodiscard]] Mesh mesh_of(const std::filesystem::path& file, std::string_view bytes,
                           const std::function<void(const std::string&)>& notice = {}, std::size_t shape = 0,
                           const LoadBudget& budget = {}, const MeshColorNames& colors = {});

}  // namespace nicol::geometry
