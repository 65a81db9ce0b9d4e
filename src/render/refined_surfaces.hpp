// SPDX-License-Identifier: MIT
// A scene's surfaces as they are drawn: with the vertices that the bake added.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <memory>
#include <vector>

#include "render/geometry.hpp"
#include "render/scene_geometry.hpp"
#include "versioned.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// A geometry with the triangles of a refinement of it, and the visibility of its vertices. Added vertices
/// follow those of the range that they lie in; positions and normals are interpolated, the normals then made
/// unit length.
struct RefinedGeometry {
    WorldGeometry geometry;
    Visibility visibility;
};
[[nodiscard]] RefinedGeometry refined(const WorldGeometry& geometry, const Refinement& refinement);

class RefinedSurfaces {
public:
    /// Takes over changes of the surfaces and of their refinement; null: there is none.
    void update(const SceneGeometry& surfaces, const std::shared_ptr<WorldGeometry>& refined);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return *geometry_; }
    /// Of vertices and triangles.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Of the ranges and their materials.
    [[nodiscard]] Version material_version() const noexcept { return material_version_; }
    /// From geometry()'s axes to the world's: a rotation and a shift.
    [[nodiscard]] const glm::dmat4& to_world() const noexcept { return to_world_; }

    /// From the version before to this one.
    struct Change {
        Version before = 0;  ///< 0: there was none
        /// 1 for vertices of this version that had the same normal, or place, under the same number.
        std::vector<std::uint8_t> same_normals;
        std::vector<std::uint8_t> same_places;
    };
    [[nodiscard]] const Change& change() const noexcept { return change_; }

private:
    std::shared_ptr<const WorldGeometry> geometry_ = std::make_shared<const WorldGeometry>();
    std::vector<VertexRange> ranges_;
    glm::dmat4 to_world_{1.0};
    Version version_ = 0;
    Version material_version_ = new_version();
    Change change_;
};

}  // namespace nicol
