// SPDX-License-Identifier: MIT
// Convex bodies with nothing inside, and the points at which rays leave them.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfaces/geometry.hpp"
#include "surfaces/lane_triangles.hpp"

namespace nicol {

/// Ranges of a geometry whose triangles have no vertex of the range above their fronts, and whose box no
/// triangle of another range touches. The triangles are the boundary, or a part of it, of a convex body
/// with nothing inside: a ray that leaves the back of one of them and meets the back of another one meets
/// nothing in between.
class ConvexBodies {
public:
    /// Knows no bodies.
    ConvexBodies() = default;
    /// Looks for bodies among some ranges of a geometry. chosen: 1 for these ranges, else 0.
    ConvexBodies(const WorldGeometry& geometry, std::span<const std::uint8_t> chosen);

    /// Returns whether a range is such a body.
    [[nodiscard]] bool has(std::size_t range) const {
        return range < bodies_.size() && !bodies_[range].triangles.empty();
    }

    /// Walks from triangles of a body to those by which rays from its inside leave it, over few neighbours.
    /// Returns the bits of the rays, among `some`, whose triangle was found. range: that of the body.
    /// triangles: of all lanes, all of the body. at, out: the triangles at which the walks end, and where the
    /// rays meet them.
    [[nodiscard]] std::uint32_t leave(std::size_t range, const LaneVectors& origins,
                                      const LaneVectors& directions, std::uint32_t some,
                                      std::array<std::uint32_t, kLanes>& triangles, LaneTriangles& at,
                                      LaneMeetings& out) const;

    [[nodiscard]] std::uint64_t bytes() const noexcept;

private:
    struct Triangle {
        std::array<float, 18> row;  // as LaneTriangles has them: positions and then normals of the corners
        // By corners, the body's triangle beyond the opposite edge; the triangle itself: none.
        std::array<std::uint32_t, 3> neighbours;
    };
    struct Body {
        std::uint32_t first = 0;          // the geometry's triangle that is triangles[0]
        std::vector<Triangle> triangles;  // empty: no such body
    };
    // Returns the triangles of a range, connected.
    static Body body_of(const WorldGeometry& geometry, std::span<const TriangleBatch> batches,
                        std::size_t range);

    std::vector<Body> bodies_;  // by ranges; empty without bodies
};

}  // namespace nicol
