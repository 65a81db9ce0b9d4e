// SPDX-License-Identifier: MIT
// Polygons as OpenMesh's readers deliver them, before anything is dropped.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/mesh.hpp"

namespace nicol::geometry {

/// Polygons that share positions and nothing else, so that every face of a file has a place here: a half-edge
/// mesh would refuse those that make it something other than a manifold.
struct Soup {
    struct Corner {
        std::uint32_t position;
        glm::vec3 normal;  ///< zero where the file gives none
    };
    std::vector<glm::vec3> positions;
    std::vector<Corner> corners;
    std::vector<std::size_t> face_ends;  ///< face f has the corners [face_ends[f - 1], face_ends[f])
};

/// Runs OpenMesh's reader for `suffix` (Vetted::suffix) over bytes that have passed vet.hpp. Any thread may
/// call. Throws Error(internal) with OpenMesh's own words if it fails all the same.
[[nodiscard]] Soup read_soup(std::string_view name, const std::string& bytes, const std::string& suffix);

/// Averages the normals of faces at each position as long as they are less than `degrees` apart.
void smooth_within_crease(Soup& soup, double degrees);

/// Cuts polygons into triangles and splits positions whose corners have different normals. `faces` receives
/// the face that each triangle comes from.
[[nodiscard]] Mesh triangulated(const Soup& soup, std::vector<std::uint32_t>& faces);

}  // namespace nicol::geometry
