// SPDX-License-Identifier: MIT
#include "specular/lane_mirror.hpp"

#include <array>
#include <cmath>

#include "polarization/lane_camera.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Half of the lanes.
constexpr std::size_t half = kLanes / 2;
using HalfLanes [[gnu::vector_size(half * sizeof(double)), gnu::may_alias]] = double;

struct Point {
    HalfLanes x, y, z;
};

struct Camera : LaneCamera {
    std::array<double, 9> to_light;  // by rows
};

[[gnu::always_inline]] inline void root(HalfLanes& x) {
    alignas(HalfLanes) std::array<double, half> each;
    *reinterpret_cast<HalfLanes*>(each.data()) = x;
    for (double& number : each) number = std::sqrt(number);
    x = *reinterpret_cast<const HalfLanes*>(each.data());
}

[[gnu::always_inline]] inline void cross(const Point& a, const Point& b, Point& out) {
    out.x = a.y * b.z - a.z * b.y;
    out.y = a.z * b.x - a.x * b.z;
    out.z = a.x * b.y - a.y * b.x;
}

[[gnu::always_inline]] inline void dot(const Point& a, const Point& b, HalfLanes& out) {
    out = a.x * b.x + a.y * b.y + a.z * b.z;
}

[[gnu::always_inline]] inline void subtract(Point& a, const HalfLanes& factor, const Point& b) {
    a.x -= factor * b.x;
    a.y -= factor * b.y;
    a.z -= factor * b.z;
}

// a over its length, or b where that is at most the root of `least`.
[[gnu::always_inline]] inline void normalize(Point& a, double least, const Point& b) {
    HalfLanes length;
    dot(a, a, length);
    const auto defined = length > least;
    length = defined ? length : HalfLanes{} + 1.0;
    root(length);
    const HalfLanes inverse = 1.0 / length;
    a.x = defined ? a.x * inverse : b.x;
    a.y = defined ? a.y * inverse : b.y;
    a.z = defined ? a.z * inverse : b.z;
}

[[gnu::always_inline]] inline void spread(const std::array<double, 3>& from, Point& to) {
    to.x = HalfLanes{} + from[0];
    to.y = HalfLanes{} + from[1];
    to.z = HalfLanes{} + from[2];
}

[[gnu::always_inline]] inline void store_half(const HalfLanes& from, Lanes& to, std::size_t first) {
    using HalfFloats [[gnu::vector_size(half * sizeof(float)), gnu::may_alias]] = float;
    *reinterpret_cast<HalfFloats*>(to.value.data() + first) = __builtin_convertvector(from, HalfFloats);
}

// In the axes of the light.
[[gnu::always_inline]] inline void store_rotated(const std::array<double, 9>& r, const Point& from,
                                                 LaneVectors& to, std::size_t first) {
    store_half(r[0] * from.x + r[1] * from.y + r[2] * from.z, to.x, first);
    store_half(r[3] * from.x + r[4] * from.y + r[5] * from.z, to.y, first);
    store_half(r[6] * from.x + r[7] * from.y + r[8] * from.z, to.z, first);
}

// Double precision: a direction is off by what a float misses once, so that large maps keep their detail.
[[gnu::always_inline]] inline void find_half(const Camera& camera, const Point& position, const Point& n,
                                             std::size_t first, LaneMirror& out) {
    // A point at the camera counts as one straight ahead, as Viewpoint::towards has it.
    Point ahead;
    spread(camera.backward, ahead);
    Point v = ahead;
    if (!camera.orthographic) {
        v.x = camera.eye[0] - position.x;
        v.y = camera.eye[1] - position.y;
        v.z = camera.eye[2] - position.z;
        normalize(v, 0, ahead);
    }
    // x of the camera's frame field, as Viewpoint::frame has it.
    Point up;
    Point right;
    Point a;
    spread(camera.up, up);
    spread(camera.right, right);
    cross(up, v, a);
    HalfLanes number;
    dot(a, a, number);
    const auto defined = number > 1e-12;
    a.x = defined ? a.x : right.x;
    a.y = defined ? a.y : right.y;
    a.z = defined ? a.z : right.z;
    dot(a, v, number);
    subtract(a, number, v);
    normalize(a, 0, right);

    HalfLanes cosine;
    dot(n, v, cosine);
    const auto faces = cosine > 0.0;
    const HalfLanes zero{};
    const HalfLanes height = faces ? cosine : zero;
    const HalfLanes depth = faces ? zero : cosine;
    Point seen = v;
    subtract(seen, depth, n);
    normalize(seen, 1e-10, a);
    Point d = seen;
    subtract(d, 2.0 * height, n);
    Point x;
    Point y;
    cross(n, seen, x);
    normalize(x, 1e-10, a);
    cross(d, x, y);

    HalfLanes c;
    HalfLanes s;
    Point across;
    cross(v, x, across);
    dot(a, x, c);
    dot(a, across, s);
    store_half(cosine, out.cosine, first);
    store_half(c * c - s * s, out.frame_cosine, first);
    store_half(2.0 * c * s, out.frame_sine, first);
    store_rotated(camera.to_light, d, out.d, first);
    store_rotated(camera.to_light, x, out.x, first);
    store_rotated(camera.to_light, y, out.y, first);
    Point inward = n;
    inward.x = -n.x;
    inward.y = -n.y;
    inward.z = -n.z;
    store_rotated(camera.to_light, inward, out.inward, first);

    HalfLanes rho = n.x * n.x + n.y * n.y;
    root(rho);
    const auto tilted = rho > 0.0;
    const HalfLanes inverse = 1.0 / (tilted ? rho : zero + 1.0);
    const HalfLanes cos_phi = tilted ? n.x * inverse : zero + 1.0;
    const HalfLanes sin_phi = n.y * inverse;
    store_half(n.z * (cos_phi * d.x + sin_phi * d.y) - rho * d.z, out.local.x, first);
    store_half(cos_phi * d.y - sin_phi * d.x, out.local.y, first);
    dot(n, d, number);
    store_half(number, out.local.z, first);
}

[[gnu::always_inline]] inline void find_mirrors(const Camera& camera, const LanePoints& positions,
                                                const LanePoints& normals, LaneMirror& out) {
    for (std::size_t first = 0; first < kLanes; first += half) {
        const auto at = [first](const DoubleLanes& lanes) -> const HalfLanes& {
            return *reinterpret_cast<const HalfLanes*>(lanes.value.data() + first);
        };
        const Point position{at(positions.x), at(positions.y), at(positions.z)};
        const Point normal{at(normals.x), at(normals.y), at(normals.z)};
        find_half(camera, position, normal, first, out);
    }
}

}  // namespace

LaneMirror mirror_views(const Viewpoint& view, const glm::dmat3& world_to_light,
                        std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    Camera camera{lane_camera(view), {}};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            camera.to_light[static_cast<std::size_t>(3 * row + column)] = world_to_light[column][row];
    }
    LaneMirror out;
    dispatch<find_mirrors>(camera, lane_points(positions), lane_points(normals), out);
    return out;
}

}  // namespace nicol
