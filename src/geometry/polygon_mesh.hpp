// SPDX-License-Identifier: MIT
// Polygons as mesh files have them, and what becomes of them.
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

/// Polygons that share positions and nothing else. Unlike a half-edge mesh it holds non-manifold faces too.
struct PolygonMesh {
    static constexpr std::uint32_t kNone = 0xffffffff;
    struct Corner {
        std::uint32_t position;
        std::uint32_t normal = kNone;
        std::uint32_t texcoord = kNone;
    };
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;  ///< of any length; zero counts as none
    std::vector<glm::vec2> texcoords;
    std::vector<glm::vec3> colors;  ///< of the positions, or empty
    std::vector<Corner> corners;
    std::vector<std::size_t> face_ends;  ///< face f has the corners [face_ends[f - 1], face_ends[f])
    std::vector<glm::vec3> face_colors;  ///< of the faces, or empty

    /// The corners since the last face are one; left out where they are fewer than 3. Returns whether it is
    /// kept.
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

/// Triangles of the polygons, which may be concave. Positions whose corners have different normals are split.
/// Missing normals are smooth over the faces that lack them; vertices without a face and triangles without
/// area are left out.
[[nodiscard]] Mesh triangulated(const PolygonMesh& polygons, std::string_view name, LeftOut& left_out,
                                const LoadBudget& budget);

/// As nicol::load_mesh() of a file that has this name and holds these bytes.
[[nodiscard]] Mesh mesh_of(const std::filesystem::path& file, std::string_view bytes,
                           const std::function<void(const std::string&)>& notice = {}, std::size_t shape = 0,
                           const LoadBudget& budget = {});

}  // namespace nicol::geometry
