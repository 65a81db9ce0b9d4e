// SPDX-License-Identifier: MIT
#include "visibility/ray_boxes.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "geometry/largest_coordinate.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Margin of boxes against rounding, relative to the largest coordinate.
constexpr float kSlackOfBox = 1e-5F;

// Corners of a box, from the start of rays.
struct Corners {
    glm::vec3 lower, upper;
};

// Narrows the parts of sixteen rays, from `first` to `last`, to those between two planes.
[[gnu::always_inline]] inline void cut(const std::array<float, RayBundle::kRays>& along, float lower,
                                       float upper, std::array<float, RayBundle::kRays>& first,
                                       std::array<float, RayBundle::kRays>& last) {
    constexpr float least = 1e-12F;  // rays parallel to the planes
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) {
        const float size = along[i] < 0 ? -along[i] : along[i];
        const float inverse = size < least ? 1 / least : 1 / along[i];
        const float a = lower * inverse, b = upper * inverse;
        const float enters = a < b ? a : b, leaves = a < b ? b : a;
        first[i] = first[i] > enters ? first[i] : enters;
        last[i] = last[i] < leaves ? last[i] : leaves;
    }
}

[[gnu::always_inline]] inline void add_bundles(std::span<const RayBundle> bundles, const Corners& box,
                                               std::uint16_t* bits) {
    for (std::size_t b = 0; b < bundles.size(); ++b) {
        std::array<float, RayBundle::kRays> first{}, last;
        last.fill(std::numeric_limits<float>::infinity());
        cut(bundles[b].x, box.lower.x, box.upper.x, first, last);
        cut(bundles[b].y, box.lower.y, box.upper.y, first, last);
        cut(bundles[b].z, box.lower.z, box.upper.z, first, last);
        std::array<std::uint16_t, RayBundle::kRays> bit{};
        for (std::size_t i = 0; i < RayBundle::kRays; ++i)
            bit[i] = first[i] <= last[i] ? static_cast<std::uint16_t>(1U << i) : std::uint16_t{0};
        for (std::size_t i = 0; i < RayBundle::kRays; ++i)
            bits[b] = static_cast<std::uint16_t>(bits[b] | bit[i]);
    }
}

}  // namespace

void add_rays_to_box(const DirectionSet& directions, const glm::vec3& origin, const Box& box,
                     std::span<std::uint16_t> bits) {
    const glm::dvec3 from(origin);
    Corners corners{glm::vec3(box.lower - from), glm::vec3(box.upper - from)};
    const float slack =
        kSlackOfBox * std::max({largest_coordinate(corners.lower), largest_coordinate(corners.upper),
                                largest_coordinate(origin)});
    corners.lower -= slack;
    corners.upper += slack;
    dispatch<add_bundles>(directions.bundles(), corners, bits.data());
}

}  // namespace nicol
