// SPDX-License-Identifier: MIT
// A scene's surfaces as drawn, including the vertices that the bake added.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "geometry/edge_bisection.hpp"
#include "surfaces/geometry.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/surface_state.hpp"
#include "versioned.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// Numbers of a refinement's vertices in RefinedGeometry. Empty: nothing is refined, and vertices keep their
/// numbers.
struct VertexNumbers {
    std::vector<std::uint32_t> numbers;  ///< index of each vertex of the refinement, given ones first
    std::vector<std::uint32_t> sources;  ///< vertex of the refinement that each vertex is or copies

    [[nodiscard]] std::uint32_t number(std::size_t i) const {
        return numbers.empty() ? static_cast<std::uint32_t>(i) : numbers[i];
    }
    [[nodiscard]] std::uint32_t source(std::size_t v) const {
        return sources.empty() ? static_cast<std::uint32_t>(v) : sources[v];
    }
    /// Returns whether a vertex copies the vertex before it.
    [[nodiscard]] bool is_copy(std::size_t v) const {
        return v > 0 && !sources.empty() && sources[v] == sources[v - 1];
    }
    /// Returns the copy of the same vertex that follows v, or v if there is none.
    [[nodiscard]] std::uint32_t next_copy(std::uint32_t v) const {
        return v + 1 < sources.size() && is_copy(v + 1) ? v + 1 : v;
    }
};

/// Geometry after refinement, and the visibility of its vertices (none if the refinement has none). Added
/// vertices follow the other vertices of their range. Their positions and normals are interpolated, and the
/// normals are then made unit length. Corners have neither texture coordinates nor colours, because
/// RefinedSurfaces interpolates these. Vertices in reserve, which no triangle uses, end a range with added
/// vertices: copies of its last vertex. Because of them, a refinement that adds a few vertices more or fewer
/// leaves the numbers of other ranges as they are.
struct RefinedGeometry {
    WorldGeometry geometry;
    Visibility visibility;
    std::vector<TrianglePart> parts;  ///< one per triangle
    VertexNumbers numbers;
};
/// Returns the geometry. most_vertices: there is no reserve if there would be more vertices than this.
[[nodiscard]] RefinedGeometry refined(const WorldGeometry& geometry, const Refinement& refinement,
                                      std::uint64_t most_vertices);

class RefinedSurfaces {
public:
    /// Takes over changes of the surfaces and of their refinement (null: none) with its parts and numbers.
    /// Sets the materials, texture coordinates and colours of `refined`.
    void update(const SceneGeometry& surfaces, const std::shared_ptr<WorldGeometry>& refined,
                std::span<const TrianglePart> parts, std::span<const std::uint32_t> numbers);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return *geometry_; }
    /// Returns the version of vertices and triangles.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Returns the version of the ranges, their materials, and the corners' texture coordinates and colours.
    [[nodiscard]] Version material_version() const noexcept { return material_version_; }
    /// Returns the rigid motion (a rotation and a shift) from geometry()'s axes to the world's.
    [[nodiscard]] const glm::dmat4& to_world() const noexcept { return to_world_; }

    /// Change from the previous version to the current one, with one number per vertex of the current
    /// version.
    struct Change {
        Version before = 0;  ///< previous version; 0: none
        /// Index in the previous version of a vertex with equal normal, or kNoVertex.
        std::vector<std::uint32_t> former;
        std::vector<std::uint8_t> same_places;  ///< 1: that vertex has an equal position, too
    };
    [[nodiscard]] const Change& change() const noexcept { return change_; }

private:
    [[nodiscard]] Change change_to(const SceneGeometry& surfaces, const WorldGeometry& next,
                                   std::span<const std::uint32_t> numbers) const;

    std::shared_ptr<const WorldGeometry> geometry_ = std::make_shared<const WorldGeometry>();
    std::vector<VertexRange> ranges_;
    glm::dmat4 to_world_{1.0};
    Version version_ = 0;
    Version material_version_ = new_version();
    Version corners_ = 0;                 // version of the surfaces' materials that the corners belong to
    Version given_version_ = 0;           // version of the surfaces before refinement
    std::size_t given_ = 0;               // number of their vertices
    std::vector<std::uint32_t> numbers_;  // numbers of the refinement; empty: nothing is refined
    Change change_;
};

}  // namespace nicol
