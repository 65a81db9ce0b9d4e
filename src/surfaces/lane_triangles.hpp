// SPDX-License-Identifier: MIT
// Triangles of sixteen points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "polarization/lane_points.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Triangles side by side.
struct LaneTriangles {
    std::array<LaneVectors, 3> corners;
    std::array<LaneVectors, 3> normals;  ///< of the corners

    /// Returns triangles by their indices, at most kLanes; the other lanes repeat the first.
    [[nodiscard]] static LaneTriangles of(const WorldGeometry& geometry,
                                          std::span<const std::uint32_t> triangles);

    /// Returns the unit geometric normals. otherwise: of triangles without an area.
    [[nodiscard]] LaneVectors facets(const LaneVectors& otherwise) const;
};

/// Edges of triangles from the first corner to the others.
template <class Number>
struct Edges {
    Vector3<Number> second, third;
};

/// Loads the edges of the part that begins at lane `first`. Number: a vector of doubles, because squares of
/// very small or large edges exceed the range of floats.
template <class Number>
[[gnu::always_inline]] inline Edges<Number> edges_of(const std::array<LaneVectors, 3>& corners,
                                                     std::size_t first) {
    Vector3<Number> from, second, third;
    load_part(corners[0], first, from);
    load_part(corners[1], first, second);
    load_part(corners[2], first, third);
    const Number one = Number{} + 1.0;
    return {minus_scaled(second, one, from), minus_scaled(third, one, from)};
}

/// Returns the tangents of a geometry at points of its triangles, see tangent(): unit, or 0 if there is none.
/// The geometry has texture coordinates and no mesh has tangents of its own. normals: unit interpolated
/// normals.
[[nodiscard]] LaneVectors texture_tangents(const WorldGeometry& geometry,
                                           std::span<const std::uint32_t> triangles,
                                           const LaneTriangles& corners, const LaneVectors& normals);

}  // namespace nicol
