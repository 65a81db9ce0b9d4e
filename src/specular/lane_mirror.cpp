// SPDX-License-Identifier: MIT
#include "specular/lane_mirror.hpp"

#include <array>
#include <cstddef>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Half of the lanes; this many doubles fill the widest registers.
constexpr std::size_t kHalf = kLanes / 2;
using HalfLanes [[gnu::vector_size(kHalf * sizeof(double))]] = double;
using HalfLanesInMemory [[gnu::vector_size(kHalf * sizeof(double)), gnu::may_alias]] = double;
using HalfFloats [[gnu::vector_size(kHalf * sizeof(float)), gnu::may_alias]] = float;
using Direction = Vector3<HalfLanes>;

[[gnu::always_inline]] inline void load_half(const LanePoints& from, std::size_t first, Direction& to) {
    to.x = *reinterpret_cast<const HalfLanesInMemory*>(from.x.value.data() + first);
    to.y = *reinterpret_cast<const HalfLanesInMemory*>(from.y.value.data() + first);
    to.z = *reinterpret_cast<const HalfLanesInMemory*>(from.z.value.data() + first);
}

[[gnu::always_inline]] inline void store_half(const HalfLanes& from, std::size_t first, Lanes& to) {
    *reinterpret_cast<HalfFloats*>(to.value.data() + first) = __builtin_convertvector(from, HalfFloats);
}

[[gnu::always_inline]] inline void store_half(const Direction& from, std::size_t first, LaneVectors& to) {
    store_half(from.x, first, to.x);
    store_half(from.y, first, to.y);
    store_half(from.z, first, to.z);
}

using Rotation = std::array<double, 9>;  // by rows

// Stores a direction in the axes of the light.
[[gnu::always_inline]] inline void store_rotated(const Rotation& r, const Direction& from, std::size_t first,
                                                 LaneVectors& to) {
    store_half(r[0] * from.x + r[1] * from.y + r[2] * from.z, first, to.x);
    store_half(r[3] * from.x + r[4] * from.y + r[5] * from.z, first, to.y);
    store_half(r[6] * from.x + r[7] * from.y + r[8] * from.z, first, to.z);
}

// Mirrors half of the lanes. Double precision keeps the error of a direction to one rounding to float, so
// that large maps keep their detail.
[[gnu::always_inline]] inline void mirror_half(const CameraAxes& camera, const Rotation& to_light,
                                               const Direction& position, const Direction& n,
                                               std::size_t first, LaneMirror& out) {
    const Direction v = towards_camera(camera, position);
    const Direction a = normalized_or(camera_x(camera.up, camera.right, v), 0.0F, camera.right);

    HalfLanes cosine;
    dot(n, v, cosine);
    const HalfLanes zero{};
    const auto faces = cosine > 0.0;
    const HalfLanes height = faces ? cosine : zero;
    const HalfLanes depth = faces ? zero : cosine;
    const Direction facing = normalized_or(minus_scaled(v, depth, n), 1e-10F, a);
    const HalfLanes twice = 2.0 * height;
    const Direction d = minus_scaled(facing, twice, n);
    const Direction x = normalized_or(cross(n, facing), 1e-10F, a);

    HalfLanes c;
    HalfLanes s;
    dot(a, x, c);
    dot(a, cross(v, x), s);
    store_half(cosine, first, out.cosine);
    store_half(c * c - s * s, first, out.frame_cosine);
    store_half(2.0 * c * s, first, out.frame_sine);
    store_rotated(to_light, d, first, out.d);
    store_rotated(to_light, x, first, out.x);
    store_rotated(to_light, cross(d, x), first, out.y);
    store_rotated(to_light, Direction{-n.x, -n.y, -n.z}, first, out.inward);
    store_half(in_frame(theta_phi_axes(n), d), first, out.local);
}

[[gnu::always_inline]] inline void mirror(const CameraAxes& camera, const Rotation& to_light,
                                          const LanePoints& positions, const LanePoints& normals,
                                          LaneMirror& out) {
    for (std::size_t first = 0; first < kLanes; first += kHalf) {
        Direction position;
        Direction normal;
        load_half(positions, first, position);
        load_half(normals, first, normal);
        mirror_half(camera, to_light, position, normal, first, out);
    }
}

}  // namespace

LaneMirror mirror_views(const Viewpoint& view, const glm::dmat3& world_to_light,
                        std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    Rotation to_light;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            to_light[static_cast<std::size_t>(3 * row + column)] = world_to_light[column][row];
    }
    LaneMirror out;
    dispatch<mirror>(view.axes(), to_light, lane_points(positions), lane_points(normals), out);
    return out;
}

}  // namespace nicol
