// SPDX-License-Identifier: MIT
// Rays of a bundle as bits, for vector instructions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Returns bits: bit i is set if the cosine between direction i and a unit vector exceeds `least`. For
/// dispatch().
[[gnu::always_inline]] inline std::uint16_t rays_above(const RayBundle& bundle, const glm::vec3& axis,
                                                       float least) {
    std::array<std::uint16_t, RayBundle::kRays> bit{};
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) {
        const float along = axis.x * bundle.x[i] + axis.y * bundle.y[i] + axis.z * bundle.z[i];
        bit[i] = along > least ? static_cast<std::uint16_t>(1U << i) : std::uint16_t{0};
    }
    std::uint16_t all = 0;
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) all = static_cast<std::uint16_t>(all | bit[i]);
    return all;
}

}  // namespace nicol
