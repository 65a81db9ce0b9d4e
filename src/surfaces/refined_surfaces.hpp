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
#include "versioned.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// Geometry after refinement, and the visibility of its vertices. Added vertices follow the other vertices of
/// their range. Their positions and normals are interpolated, and the normals are then made unit length.
/// Corners have neither texture coordinates nor colours, because RefinedSurfaces interpolates these.
struct RefinedGeometry {
    WorldGeometry geometry;
    Visibility visibility;
    std::vector<TrianglePart> parts;  ///< one per triangle
};
[[nodiscard]] RefinedGeometry refined(const WorldGeometry& geometry, const Refinement& refinement);

class RefinedSurfaces {
public:
    /// Takes over changes of the surfaces and of their refinement (null: none). Sets the materials, texture
    /// coordinates and colours of `refined`.
    void update(const SceneGeometry& surfaces, const std::shared_ptr<WorldGeometry>& refined,
                std::span<const TrianglePart> parts);

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
        Version before = 0;                      ///< previous version; 0: none
        std::vector<std::uint8_t> same_normals;  ///< 1: the normal at the vertex's index is unchanged
        std::vector<std::uint8_t> same_places;   ///< 1: the position at the vertex's index is unchanged
    };
    [[nodiscard]] const Change& change() const noexcept { return change_; }

private:
    std::shared_ptr<const WorldGeometry> geometry_ = std::make_shared<const WorldGeometry>();
    std::vector<VertexRange> ranges_;
    glm::dmat4 to_world_{1.0};
    Version version_ = 0;
    Version material_version_ = new_version();
    Version corners_ = 0;  // version of the surfaces' materials that the corners belong to
    Change change_;
};

}  // namespace nicol
