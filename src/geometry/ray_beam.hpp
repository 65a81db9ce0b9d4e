// SPDX-License-Identifier: MIT
// Rays so close to each other that Embree traces them faster as one beam. Rays that facets scatter
// are none.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Least cosine between the first and any other ray of a beam.
inline constexpr double kBeam = 0.95;

/// Returns whether some rays, at least one, are a beam.
[[nodiscard]] inline bool is_beam(std::span<const Ray> rays) {
    return std::ranges::all_of(
        rays, [&](const Ray& ray) { return glm::dot(ray.direction, rays.front().direction) > kBeam; });
}
/// Returns whether the rays of a packet whose bit in `active` is set, at least one, are a beam.
[[nodiscard]] inline bool is_beam(const RayPacket& packet, std::uint16_t active) {
    const auto direction = [&](std::size_t i) {
        return glm::vec3(packet.direction_x[i], packet.direction_y[i], packet.direction_z[i]);
    };
    const glm::vec3 first = direction(static_cast<std::size_t>(std::countr_zero(active)));
    for (std::size_t i = 0; i < RayPacket::kRays; ++i)
        if ((active >> i & 1) != 0 && !(glm::dot(direction(i), first) > static_cast<float>(kBeam)))
            return false;
    return true;
}

}  // namespace nicol
