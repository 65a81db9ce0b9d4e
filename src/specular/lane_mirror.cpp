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

// Unit vectors towards the viewers, and the x axes of their frames.
struct Sight {
    Direction towards, x;
};

[[gnu::always_inline]] inline Sight sight_of_half(const CameraAxes& camera, const LanePoints& positions,
                                                  std::size_t first) {
    Direction position;
    load_half(positions, first, position);
    const Direction v = towards_camera(camera, position);
    return {v, normalized_or(camera_x(camera.up, camera.right, v), 0.0F, camera.right)};
}

[[gnu::always_inline]] inline void load_half(const LaneVectors& from, std::size_t first, Direction& to) {
    to.x =
        __builtin_convertvector(*reinterpret_cast<const HalfFloats*>(from.x.value.data() + first), HalfLanes);
    to.y =
        __builtin_convertvector(*reinterpret_cast<const HalfFloats*>(from.y.value.data() + first), HalfLanes);
    to.z =
        __builtin_convertvector(*reinterpret_cast<const HalfFloats*>(from.z.value.data() + first), HalfLanes);
}

[[gnu::always_inline]] inline Sight sight_of_half(const LaneSights& sights, const LanePoints& /*positions*/,
                                                  std::size_t first) {
    Sight out;
    load_half(sights.towards, first, out.towards);
    load_half(sights.x, first, out.x);
    return out;
}

// Mirrors half of the lanes. Double precision keeps the error of a direction to one rounding to float, so
// that large maps keep their detail.
[[gnu::always_inline]] inline void mirror_half(const Sight& sight, const Rotation& to_light,
                                               const Direction& n, std::size_t first, LaneMirror& out) {
    const Direction& v = sight.towards;
    const Direction& a = sight.x;

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

template <class Sights>
[[gnu::always_inline]] inline void mirror(const Sights& sights, const Rotation& to_light,
                                          const LanePoints& positions, const LanePoints& normals,
                                          LaneMirror& out) {
    for (std::size_t first = 0; first < kLanes; first += kHalf) {
        Direction normal;
        load_half(normals, first, normal);
        mirror_half(sight_of_half(sights, positions, first), to_light, normal, first, out);
    }
}

}  // namespace

LaneMirror mirror_views(const Views& views, const glm::dmat3& world_to_light,
                        std::span<const glm::vec3> positions, std::span<const glm::vec3> normals) {
    Rotation to_light;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            to_light[static_cast<std::size_t>(3 * row + column)] = world_to_light[column][row];
    }
    LaneMirror out;
    with_sights(views, positions, [&]<class Sights>(const Sights& sights) {
        dispatch<mirror<Sights>>(sights, to_light, lane_points(positions), lane_points(normals), out);
    });
    return out;
}

}  // namespace nicol
