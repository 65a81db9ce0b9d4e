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

/// Points at which sixteen rays meet the planes of one triangle each.
struct LaneMeetings {
    Lanes distances, b1, b2;  ///< as in RayHit; undefined of a ray along the plane
    /// -1: the ray meets the back of the triangle, inside its edges; else the number of the corner opposite
    /// the edge that it is farthest beyond.
    Lanes beyond;
};
/// Finds where rays in unit directions meet the planes of triangles. Rays meet no back of triangles smaller
/// than about 1e-12 or larger than 1e12, because products of floats would leave their range, nor backs
/// nearer than rays start from triangles, see ray_offset(), where rounding would decide.
void meet_planes(const LaneVectors& origins, const LaneVectors& directions, const LaneTriangles& triangles,
                 LaneMeetings& out);

/// Edges of triangles from the first corner to the others.
template <class Number>
struct Edges {
    Vector3<Number> second, third;
};

/// Loads the edges of the part that begins at lane `first`. Number: a vector of doubles for triangles of any
/// size, because squares of very small or large edges exceed the range of floats.
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

/// Returns the change of a triangle's interpolated normal along a way in its plane, orthogonal to the unit
/// normal. changes: of the normals, from the first corner to the others.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> bend(const Edges<Number>& edges, const Edges<Number>& changes,
                                                   const Vector3<Number>& way,
                                                   const Vector3<Number>& normal) {
    const Vector3<Number> across = cross(edges.second, edges.third);
    Number area2, along_second, along_third, rise;
    dot(across, across, area2);
    const Number inverse = area2 > 0.0 ? 1.0 / area2 : Number{};
    dot(cross(way, edges.third), across, along_second);
    dot(cross(edges.second, way), across, along_third);
    along_second *= inverse;
    along_third *= inverse;
    const Vector3<Number> here{along_second * changes.second.x + along_third * changes.third.x,
                               along_second * changes.second.y + along_third * changes.third.y,
                               along_second * changes.second.z + along_third * changes.third.z};
    dot(here, normal, rise);
    return minus_scaled(here, rise, normal);
}

/// Computes twice the volume that an edge from a to b and a direction span, seen from the origin (Pluecker's
/// coordinates). It is positive if the direction passes the edge on its left, seen against the direction.
template <class Number>
[[gnu::always_inline]] inline void pass_edge(const Vector3<Number>& a, const Vector3<Number>& b,
                                             const Vector3<Number>& direction, Number& out) {
    const Number one = Number{} + 1.0F;
    dot(cross(minus_scaled(a, one, b), minus_scaled(a, Number(-one), b)), direction, out);
}

/// Raises `largest` to the largest coordinate of a vector.
template <class Number>
[[gnu::always_inline]] inline void raise(const Vector3<Number>& v, Number& largest) {
    for (const Number& number : {v.x, v.y, v.z}) {
        const Number size = number < 0.0F ? -number : number;
        largest = size > largest ? size : largest;
    }
}

/// Returns the tangents of a geometry at points of its triangles, see tangent(): unit, or 0 if there is none.
/// The geometry has texture coordinates and no mesh has tangents of its own. normals: unit interpolated
/// normals.
[[nodiscard]] LaneVectors texture_tangents(const WorldGeometry& geometry,
                                           std::span<const std::uint32_t> triangles,
                                           const LaneTriangles& corners, const LaneVectors& normals);

}  // namespace nicol
