// SPDX-License-Identifier: MIT
// A scene's instances as one list of vertices and triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "material/spatial_variation.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// Consecutive vertices of one instance.
struct VertexRange {
    std::size_t first;
    std::size_t last;
    MaterialPtr material;
    std::uint32_t instance;          ///< id of the instance
    EmissionPtr emission = nullptr;  ///< null: the instance emits no light
    InstanceRoles roles{};
    bool operator==(const VertexRange&) const = default;
};

/// Vertices and triangles of all instances. An instance of a two-sided material appears twice, the second
/// time with reversed winding and normals, so that each side has its own vertices. Only the front sides of
/// these triangles may be drawn.
struct WorldGeometry {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::uvec3> triangles;  ///< one-sided triangles first
    std::size_t one_sided = 0;          ///< number of one-sided triangles
    std::vector<VertexRange> ranges;
    /// Triangles as shadow rays meet them, see BakeGeometry::blocking; not set after refinement, which
    /// divides triangles and moves none.
    std::vector<glm::uvec3> blocking;

    /// Texture coordinates of the triangles' corners, in the order of `triangles`; 0 for meshes without
    /// texture coordinates. Empty unless a textured or anisotropic material or a textured emission needs
    /// them.
    std::vector<std::array<glm::vec2, 3>> texcoords;
    /// Mesh colours at the triangles' corners, of vertices or of faces as the material needs, in the order of
    /// `triangles`; 1 for meshes without such colours. Empty unless a material needs them.
    std::vector<std::array<glm::vec3, 3>> colors;
    /// Tangents of the triangles' corners (Mesh::tangents), in the order of `triangles`; the y axis refers to
    /// the normal of the front. Empty unless a mesh of a material with a normal map or of an anisotropic
    /// material has tangents; 0 for other meshes.
    std::vector<std::array<glm::vec4, 3>> tangents;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return (positions.size() + normals.size()) * sizeof(glm::vec3) +
               (triangles.size() + blocking.size()) * sizeof(glm::uvec3) +
               texcoords.size() * sizeof(texcoords.front()) + colors.size() * sizeof(colors.front()) +
               tangents.size() * sizeof(tangents.front());
    }
};

/// Returns whether a range is the second side of a two-sided instance.
[[nodiscard]] inline bool is_back(const WorldGeometry& geometry, const VertexRange& range) {
    const auto* const first = geometry.ranges.data();
    return &range != first && (&range)[-1].instance == range.instance;
}

/// Returns the index of the range that contains a vertex.
[[nodiscard]] std::size_t range_of(const WorldGeometry& geometry, std::size_t vertex);

/// Consecutive triangles of one range.
struct TriangleBatch {
    std::size_t range;  ///< index of the range
    bool two_sided;
    std::size_t first;
    std::size_t last;
};
[[nodiscard]] std::vector<TriangleBatch> triangle_batches(const WorldGeometry& geometry);

/// Returns whether a material has an alpha mask.
[[nodiscard]] bool has_masks(const WorldGeometry& geometry);
/// Returns whether a triangle's surface is present at a point. b1, b2: barycentric weights of corners 1
/// and 2. threshold: that of SpatialVariation::present().
[[nodiscard]] bool is_present(const WorldGeometry& geometry, std::uint32_t triangle, float b1, float b2,
                              float threshold);

/// Returns the alpha masks of the geometry's triangles, for rays; empty if no material has an alpha mask. The
/// geometry must outlive the result.
[[nodiscard]] Presence presence_of(const WorldGeometry& geometry);
/// Returns the alpha masks of some triangles, which hits have the given numbers; empty if none of their
/// materials has an alpha mask. triangles: how many there are. Keeps what it needs of the geometry.
[[nodiscard]] Presence presence_of(const WorldGeometry& geometry, std::span<const TriangleNumbers> numbers,
                                   std::size_t triangles);

/// Returns 1 for each vertex of an instance that receives shadows, else 0; empty if all do.
[[nodiscard]] std::vector<std::uint8_t> receivers_of(const WorldGeometry& geometry);

/// Returns the geometry's triangles, with those of invisible instances collapsed to a corner. `room` holds
/// the result if there are such instances.
[[nodiscard]] std::span<const glm::uvec3> shown_triangles(const WorldGeometry& geometry,
                                                          std::vector<glm::uvec3>& room);

/// Sets visible[v] to 1 for each vertex of a visible triangle that faces the viewpoint and is not wholly
/// outside one side of the view by more than half a pixel, the distance of samples from pixel centres. Sets
/// visible[v] to 0 for the other vertices, which cannot reach the image. Resizes `visible`. Returns the
/// number of zeros. Runs on the calling thread's TBB arena.
std::size_t find_visible(const WorldGeometry& geometry, const Projection& projection,
                         std::vector<std::uint8_t>& visible);

}  // namespace nicol
