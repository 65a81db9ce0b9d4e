// SPDX-License-Identifier: MIT
// Search for the points of surfaces that rays meet, by the side that surfaces show.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "visibility/bake.hpp"

namespace nicol {

/// Triangles of a geometry by the side that they show.
struct TriangleSides {
    std::vector<std::uint32_t> fronts;  ///< one-sided triangles and the fronts of two-sided surfaces
    std::vector<std::uint32_t> backs;   ///< the backs of two-sided surfaces
};

/// Ray hierarchies of both sides of a geometry. Immutable; threads share it.
class SurfacePoints {
public:
    /// The arguments must outlive the object.
    SurfacePoints(const BakeGeometry& geometry, const TriangleSides& sides);
    ~SurfacePoints();
    SurfacePoints(const SurfacePoints&) = delete;
    SurfacePoints& operator=(const SurfacePoints&) = delete;

    /// Returns the first point of a surface that faces the ray; none if something without light hides it.
    /// RayHit::triangle is an index into the geometry's triangles.
    [[nodiscard]] std::optional<RayHit> find(const Ray& ray) const;

private:
    class Triangles;

    [[nodiscard]] bool faces(const RayHit& hit, const glm::dvec3& direction) const;

    const BakeGeometry& geometry_;
    std::unique_ptr<const Triangles> fronts_;
    std::unique_ptr<const Triangles> backs_;  // null: no surface has two sides
};

}  // namespace nicol
