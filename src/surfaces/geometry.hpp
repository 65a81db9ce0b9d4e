// SPDX-License-Identifier: MIT
// A scene's instances as one list of vertices and triangles.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "material/spatial_variation.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// A run of vertices of one instance.
struct VertexRange {
    std::size_t first;
    std::size_t last;
    MaterialPtr material;
    std::uint32_t instance;          ///< id
    EmissionPtr emission = nullptr;  ///< null: it emits no light
    bool operator==(const VertexRange&) const = default;
};

/// An instance of a two-sided material appears twice, the second time with reversed winding and normals, so
/// that each side has vertices of its own; only the fronts of these triangles may be drawn.
struct WorldGeometry {
    std::vector<glm::vec3> positions;
    std::vector<glm::vec3> normals;
    std::vector<glm::uvec3> triangles;  ///< one-sided ones first
    std::size_t one_sided = 0;          ///< how many of them
    std::vector<VertexRange> ranges;

    /// Of the corners of triangles, in their order, 0 for meshes without any; empty unless materials that
    /// vary or are anisotropic need them.
    std::vector<std::array<glm::vec2, 3>> texcoords;
    /// Likewise the mesh's colours that the material takes, of vertices or of faces; 1 for meshes without
    /// any.
    std::vector<std::array<glm::vec3, 3>> colors;

    [[nodiscard]] std::size_t bytes() const noexcept {
        return (positions.size() + normals.size()) * sizeof(glm::vec3) +
               triangles.size() * sizeof(glm::uvec3) + texcoords.size() * sizeof(texcoords.front()) +
               colors.size() * sizeof(colors.front());
    }
};

/// Whether a range is the second side of a two-sided instance.
[[nodiscard]] inline bool is_back(const WorldGeometry& geometry, const VertexRange& range) {
    const auto* const first = geometry.ranges.data();
    return &range != first && (&range)[-1].instance == range.instance;
}

/// The number of the range that a vertex is in.
[[nodiscard]] std::size_t range_of(const WorldGeometry& geometry, std::size_t vertex);

/// Consecutive triangles of one range.
struct TriangleBatch {
    std::size_t range;  ///< its number
    bool two_sided;
    std::size_t first;
    std::size_t last;
};
[[nodiscard]] std::vector<TriangleBatch> triangle_batches(const WorldGeometry& geometry);

/// Where the geometry's triangles are, for rays; it must outlive the result. Empty where all are whole.
[[nodiscard]] Presence presence_of(const WorldGeometry& geometry);

/// 1 for each vertex of a triangle that faces the viewpoint and is not wholly outside one side of the view by
/// half a pixel, as far as samples are from centres; the others cannot reach the image. Resizes `visible`;
/// returns how many are 0. Runs on the calling thread's TBB arena.
std::size_t find_visible(const WorldGeometry& geometry, const Projection& projection,
                         std::vector<std::uint8_t>& visible);

}  // namespace nicol
