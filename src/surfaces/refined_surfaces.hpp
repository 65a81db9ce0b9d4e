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

/// Geometry after refinement, and the visibility of its vertices (none if the refinement has none). Added
/// vertices follow the other vertices of their range. Their positions and normals are interpolated, and the
/// normals are then made unit length. Corners have neither texture coordinates nor colours, because
/// RefinedSurfaces interpolates these.
struct RefinedGeometry {
    WorldGeometry geometry;
    Visibility visibility;
    std::vector<TrianglePart> parts;     ///< one per triangle
    std::vector<std::uint32_t> numbers;  ///< index of each vertex of the refinement, given ones first
};
[[nodiscard]] RefinedGeometry refined(const WorldGeometry& geometry, const Refinement& refinement);

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
