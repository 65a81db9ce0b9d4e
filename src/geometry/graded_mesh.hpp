// SPDX-License-Identifier: MIT
// Division of triangles that are far larger than an object beside them.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/ball.hpp"
#include "geometry/box.hpp"
#include "geometry/mesh.hpp"

namespace nicol {

/// Sizes of a mesh and of its triangles.
struct MeshExtent {
    Ball ball;          ///< ball around the mesh
    Box box;            ///< box around the mesh
    Ball detail;        ///< ball around the triangles far smaller than the largest; `ball` if there are none
    float longest = 0;  ///< length of the longest edge
    bool operator==(const MeshExtent&) const = default;
};
[[nodiscard]] MeshExtent extent_of(const Mesh& mesh);

/// Objects of a scene that are far smaller than triangles beside them.
class Details {
public:
    /// extents: extents of all meshes of the scene, in the same coordinates.
    explicit Details(std::span<const MeshExtent> extents);

    /// Returns the objects that may be far smaller than a triangle of the mesh beside them, in an order that
    /// depends on the set alone.
    [[nodiscard]] std::vector<Ball> beside(const MeshExtent& mesh) const;

private:
    std::vector<Ball> sorted_;  // by radius
};

/// Returns the mesh with the triangles divided that are far larger than an object beside them; null if there
/// are none. A triangle of a floor that is a million times as large as a ball on it has neither positions nor
/// ray intersections at the ball that are accurate to the ball's size, and interpolation between its corners
/// misses the ball's shadow. The division starts where triangles are 1,000 times as large as an object and
/// its distance, and ends at 64 times. The surface does not change.
[[nodiscard]] std::shared_ptr<const Mesh> graded(const Mesh& mesh, std::span<const Ball> details);

}  // namespace nicol
