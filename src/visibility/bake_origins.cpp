// SPDX-License-Identifier: MIT
#include "visibility/bake_origins.hpp"

#include <algorithm>
#include <cstdint>
#include <glm/geometric.hpp>

#include "geometry/largest_coordinate.hpp"
#include "geometry/ray_scene.hpp"
#include "geometry/welded_positions.hpp"

namespace nicol {
namespace {

// Returns, for each vertex, the largest coordinate of any triangle at its position.
std::vector<float> reaches(const BakeGeometry& baked) {
    const std::span<const glm::vec3> positions = baked.positions;
    std::vector<float> reach(positions.size());
    for (std::size_t v = 0; v < reach.size(); ++v) reach[v] = largest_coordinate(positions[v]);
    for (const glm::uvec3& t : baked.triangles) {
        const float largest =
            std::max({largest_coordinate(positions[t.x]), largest_coordinate(positions[t.y]),
                      largest_coordinate(positions[t.z])});
        for (const std::uint32_t v : {t.x, t.y, t.z}) reach[v] = std::max(reach[v], largest);
    }
    // Vertices at one position get the largest.
    const std::vector<std::uint32_t> first_of = welded_positions(positions);
    for (std::size_t v = 0; v < reach.size(); ++v)
        reach[first_of[v]] = std::max(reach[first_of[v]], reach[v]);
    for (std::size_t v = 0; v < reach.size(); ++v) reach[v] = reach[first_of[v]];
    return reach;
}

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}

// Returns the sum of the unit vectors along the edges of each vertex's triangles; they cancel inside a
// surface.
std::vector<glm::vec3> inward(const BakeGeometry& geometry) {
    std::vector<glm::vec3> out(geometry.positions.size(), glm::vec3(0));
    for (const glm::uvec3& t : geometry.triangles) {
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::uint32_t from = t[k];
            const std::uint32_t to = t[(k + 1) % 3];
            const glm::vec3 edge =
                unit_or_zero(glm::dvec3(geometry.positions[to]) - glm::dvec3(geometry.positions[from]));
            out[from] += edge;
            out[to] -= edge;
        }
    }
    return out;
}

}  // namespace

std::vector<glm::vec3> bake_origins(const BakeGeometry& geometry, std::span<const glm::vec3> unit_normals) {
    const std::vector<float> reach = reaches(geometry);
    std::vector<glm::vec3> origins = inward(geometry);
    for (std::size_t v = 0; v < origins.size(); ++v) {
        const glm::vec3& normal = unit_normals[v];
        glm::vec3 tangent = origins[v] - glm::dot(origins[v], normal) * normal;
        const float length = glm::length(tangent);
        // A short remainder has no meaningful direction: it is what rounding leaves of edges that cancel.
        tangent = length > 1e-2F ? tangent / length : glm::vec3(0);
        const float step = static_cast<float>(kRayOffset) * reach[v];
        origins[v] = geometry.positions[v] + step * (normal + tangent);
    }
    return origins;
}

}  // namespace nicol
