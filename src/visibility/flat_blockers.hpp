// SPDX-License-Identifier: MIT
// Large flat faces that certainly block rays.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Large flat faces of a geometry, such as floors and walls: convex polygons that triangles cover without
/// gaps. A ray into the cone from a point to such a polygon is blocked, whatever else it meets, and need not
/// be traced. Rays closer than a thousandth of a radian to the polygon's border do not count.
class FlatBlockers {
public:
    FlatBlockers() = default;
    /// Finds no faces.
    explicit FlatBlockers(std::span<const glm::uvec3> triangles)
        : others_(triangles.begin(), triangles.end()) {}
    /// triangles: those that block rays, all of them without an alpha mask.
    FlatBlockers(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

    /// Largest number of edges of a face.
    static constexpr std::size_t kMostEdges = 8;
    /// Cone from a point to a face: directions above all of the planes with these unit normals.
    struct Cone {
        std::array<glm::vec3, kMostEdges> normals{};
        std::size_t count = 0;
    };
    /// Returns the triangles, in their order, that belong to no face.
    [[nodiscard]] std::span<const glm::uvec3> other_triangles() const noexcept { return others_; }

    /// Sets the cones to the faces of which some part is above the horizon of a point.
    /// Returns false if there may be other rays that meet a face, because the point is close to its plane.
    bool find(const glm::vec3& origin, const glm::vec3& normal, std::vector<Cone>& cones) const;

    /// Returns those of a bundle's rays, among `rays`, that lie in any of the cones.
    [[nodiscard]] static std::uint16_t blocked(std::span<const Cone> cones, const RayBundle& bundle,
                                               std::uint16_t rays);
    /// Returns those of a bundle's rays that may meet a face in any of the cones, border included.
    [[nodiscard]] static std::uint16_t reaching(std::span<const Cone> cones, const RayBundle& bundle);

private:
    /// Edges of a convex polygon, which lies to their left as seen from the tip of its normal.
    struct Face {
        glm::dvec3 normal{0.0};  ///< unit
        glm::dvec3 middle{0.0};
        double size = 0;  ///< largest coordinate
        std::size_t count = 0;
        std::array<std::array<glm::dvec3, 2>, kMostEdges> edges{};
    };
    /// Adds the face of connected triangles in one plane. Returns false if it is not convex.
    bool add(std::span<const glm::vec3> positions, std::span<const glm::uvec3> triangles);

    std::vector<Face> faces_;
    std::vector<glm::uvec3> others_;
};

}  // namespace nicol
