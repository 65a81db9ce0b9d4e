// SPDX-License-Identifier: MIT
// A scene's surfaces as they are drawn: with the vertices that the bake added.
#pragma once

#include <array>
#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <span>
#include <vector>

#include "surfaces/geometry.hpp"
#include "surfaces/scene_geometry.hpp"
#include "versioned.hpp"
#include "visibility/refine.hpp"

namespace nicol {

/// Where a triangle of a refinement lies in the triangle it is a part of.
struct TrianglePart {
    std::uint32_t source;
    std::array<glm::vec3, 3> corners;  ///< barycentric
};

/// A geometry with the triangles of a refinement of it, and the visibility of its vertices. Added vertices
/// follow those of the range that they lie in; positions and normals are interpolated, the normals then made
/// unit length. Corners have neither texture coordinates nor colours: RefinedSurfaces interpolates these.
struct RefinedGeometry {
    WorldGeometry geometry;
    Visibility visibility;
    std::vector<TrianglePart> parts;  ///< by triangle
};
[[nodiscard]] RefinedGeometry refined(const WorldGeometry& geometry, const Refinement& refinement);

class RefinedSurfaces {
public:
    /// Takes over changes of the surfaces and of their refinement; null: there is none. Materials and what
    /// corners have are set in `refined`.
    void update(const SceneGeometry& surfaces, const std::shared_ptr<WorldGeometry>& refined,
                std::span<const TrianglePart> parts);

    [[nodiscard]] const WorldGeometry& geometry() const noexcept { return *geometry_; }
    /// Of vertices and triangles.
    [[nodiscard]] Version version() const noexcept { return version_; }
    /// Of the ranges and their materials, and of what corners have.
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
    Version corners_ = 0;  // of the surfaces' materials that the corners are of
    Change change_;
};

}  // namespace nicol
