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

/// Ranges of a geometry whose triangles have no vertex of the range above their fronts, and in whose box
/// there is no triangle of another range. The triangles are the boundary, or a part of it, of a convex body
/// with nothing inside: a ray that leaves the back of one of them and meets the back of another one meets
/// nothing in between.
class ConvexBodies {
public:
    /// Knows no bodies.
    ConvexBodies() = default;
    /// Looks for bodies among some ranges of a geometry. chosen: 1 for these ranges, else 0.
    ConvexBodies(const WorldGeometry& geometry, std::span<const std::uint8_t> chosen);

    /// Returns whether a range is such a body.
    [[nodiscard]] bool has(std::size_t range) const { return range < convex_.size() && convex_[range] != 0; }

    /// Walks from triangles of a body to those by which rays from its inside leave it, over few neighbours.
    /// Returns the bits of the rays, among `some`, whose triangle was found. triangles: of all lanes, all of
    /// the body. at, out: the triangles at which the walks end, and where the rays meet them.
    [[nodiscard]] std::uint32_t leave(const LaneVectors& origins, const LaneVectors& directions,
                                      std::uint32_t some, std::array<std::uint32_t, kLanes>& triangles,
                                      LaneTriangles& at, LaneMeetings& out) const;

    [[nodiscard]] std::uint64_t bytes() const noexcept {
        return convex_.size() + rows_.size() * sizeof(Row) + neighbours_.size() * sizeof(std::uint32_t);
    }

private:
    std::vector<std::uint8_t> convex_;  // 1: bodies, by ranges
    // As LaneTriangles has them: positions and then normals of a triangle's corners. Those of other triangles
    // are undefined. Empty without bodies.
    using Row = std::array<float, 18>;
    std::vector<Row> rows_;
    // [3 triangle + corner]: the body's triangle beyond the edge opposite the corner; the triangle itself:
    // none.
    std::vector<std::uint32_t> neighbours_;
};

}  // namespace nicol
