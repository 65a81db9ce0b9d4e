// SPDX-License-Identifier: MIT
// Rays of a bundle as bits, for vector instructions.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Returns the bits of a bundle's directions in words as of Visibility.
[[nodiscard, gnu::always_inline]] inline std::uint16_t bundle_bits(const std::uint64_t* words,
                                                                   std::size_t bundle) {
    return static_cast<std::uint16_t>(words[bundle / 4] >> (16 * (bundle % 4)));
}
/// Sets the bits of a bundle's directions that are set in `bits`.
inline void add_bundle_bits(std::span<std::uint64_t> words, std::size_t bundle, unsigned bits) {
    words[bundle / 4] |= static_cast<std::uint64_t>(bits & 0xFFFFU) << (16 * (bundle % 4));
}

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
