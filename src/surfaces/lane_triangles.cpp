// SPDX-License-Identifier: MIT
#include "surfaces/lane_triangles.hpp"

#include "geometry/ray_scene.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

template <class Number>
[[gnu::always_inline]] inline void find_facets(const LaneTriangles& triangles, const LaneVectors& otherwise,
                                               LaneVectors& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        const Edges<Number> edges = edges_of<Number>(triangles.corners, first);
        Vector3<Number> other;
        load_part(otherwise, first, other);
        const Vector3<Number> normal = cross(edges.second, edges.third);
        Number length;
        dot(normal, normal, length);
        const auto defined = length > 0.0;
        length = defined ? length : Number{} + 1.0;
        square_root(length);
        const Number inverse = 1.0 / length;
        store_part(
            Vector3<Number>{defined ? normal.x * inverse : other.x, defined ? normal.y * inverse : other.y,
                            defined ? normal.z * inverse : other.z},
            first, out);
    }
}

// Texture coordinates (u, v) of corners.
using LaneTexcoords = std::array<std::array<Lanes, 2>, 3>;

template <class Number>
[[gnu::always_inline]] inline void find_tangents(const LaneTriangles& triangles,
                                                 const LaneTexcoords& texcoords, const LaneVectors& normals,
                                                 LaneVectors& out) {
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        const Edges<Number> edges = edges_of<Number>(triangles.corners, first);
        std::array<std::array<Number, 2>, 3> at;
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t i = 0; i < 2; ++i) load_part(texcoords[k][i], first, at[k][i]);
        const Number second_u = at[1][0] - at[0][0], second_v = at[1][1] - at[0][1];
        const Number third_u = at[2][0] - at[0][0], third_v = at[2][1] - at[0][1];
        const Number area = second_u * third_v - second_v * third_u;
        const Number sign = area < 0.0 ? Number{} - 1.0 : Number{} + 1.0;
        const Vector3<Number> by_u{sign * (third_v * edges.second.x - second_v * edges.third.x),
                                   sign * (third_v * edges.second.y - second_v * edges.third.y),
                                   sign * (third_v * edges.second.z - second_v * edges.third.z)};
        Vector3<Number> normal;
        load_part(normals, first, normal);
        Number rise, length;
        dot(by_u, normal, rise);
        const Vector3<Number> along = minus_scaled(by_u, rise, normal);
        dot(along, along, length);
        square_root(length);
        const Number some = area == 0.0 ? Number{} : length;
        const Number inverse = some > 0.0 ? 1.0 / some : Number{};
        store_part(Vector3<Number>{along.x * inverse, along.y * inverse, along.z * inverse}, first, out);
    }
}

template <class Number>
[[gnu::always_inline]] inline void meet_all(const LaneVectors& origins, const LaneVectors& directions,
                                            const LaneTriangles& triangles, LaneMeetings& out) {
    constexpr float small = 1e-24F, large = 1e24F;
    const Number one = Number{} + 1.0F;
    for (std::size_t first = 0; first < kLanes; first += kPart<Number>) {
        Vector3<Number> origin, direction;
        load_part(origins, first, origin);
        load_part(directions, first, direction);
        std::array<Vector3<Number>, 3> corners;
        Number nearest{};
        for (std::size_t k = 0; k < 3; ++k) {
            load_part(triangles.corners[k], first, corners[k]);
            raise(corners[k], nearest);
            corners[k] = minus_scaled(corners[k], one, origin);
        }
        nearest *= static_cast<float>(kRayOffset);
        const auto& [a, b, c] = corners;
        Number of_a, of_b, of_c, height, ahead;
        pass_edge(b, c, direction, of_a);
        pass_edge(c, a, direction, of_b);
        pass_edge(a, b, direction, of_c);
        const Number sum = of_a + of_b + of_c;
        const Vector3<Number> normal = cross(minus_scaled(b, one, a), minus_scaled(c, one, a));
        dot(a, normal, height);
        dot(direction, normal, ahead);
        const Number distance = height / ahead, inverse = 1.0F / sum;
        store_part(distance, first, out.distances);
        store_part(Number(of_b * inverse), first, out.b1);
        store_part(Number(of_c * inverse), first, out.b2);
        Number least = of_a < of_b ? of_a : of_b;
        Number beyond = of_a < of_b ? Number{} : one;
        beyond = of_c < least ? one + one : beyond;
        least = of_c < least ? of_c : least;
        least = sum > small ? least : -one;
        least = sum < large ? least : -one;
        least = distance > nearest ? least : -one;
        store_part(Number(least >= 0.0F ? -one : beyond), first, out.beyond);
    }
}

}  // namespace

LaneTriangles LaneTriangles::of(const WorldGeometry& geometry, std::span<const std::uint32_t> triangles) {
    LaneTriangles out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::uvec3& corners = geometry.triangles[triangles[i < triangles.size() ? i : 0]];
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t corner = corners[static_cast<glm::length_t>(k)];
            put(out.corners[k], i, geometry.positions[corner]);
            put(out.normals[k], i, geometry.normals[corner]);
        }
    }
    return out;
}

void meet_planes(const LaneVectors& origins, const LaneVectors& directions, const LaneTriangles& triangles,
                 LaneMeetings& out) {
    dispatch<meet_all<FourLanes>, meet_all<EightLanes>, meet_all<AllLanes>>(origins, directions, triangles,
                                                                            out);
}

LaneVectors LaneTriangles::facets(const LaneVectors& otherwise) const {
    LaneVectors out;
    dispatch<find_facets<TwoDoubles>, find_facets<FourDoubles>, find_facets<EightDoubles>>(*this, otherwise,
                                                                                           out);
    return out;
}

LaneVectors texture_tangents(const WorldGeometry& geometry, std::span<const std::uint32_t> triangles,
                             const LaneTriangles& corners, const LaneVectors& normals) {
    LaneTexcoords texcoords;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::array<glm::vec2, 3>& own = geometry.texcoords[triangles[i < triangles.size() ? i : 0]];
        for (std::size_t k = 0; k < 3; ++k) {
            texcoords[k][0][i] = own[k].x;
            texcoords[k][1][i] = own[k].y;
        }
    }
    LaneVectors out;
    dispatch<find_tangents<TwoDoubles>, find_tangents<FourDoubles>, find_tangents<EightDoubles>>(
        corners, texcoords, normals, out);
    return out;
}

}  // namespace nicol
