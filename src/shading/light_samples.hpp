// SPDX-License-Identifier: MIT
// Light samples: choice of points on a light that has a size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <span>

#include "simd/lanes.hpp"
#include "simd/mixed_bits.hpp"

namespace nicol {

/// Computes a point of [0, 1)^2 for each of up to sixteen seeds: the `index`-th point of Sobol's first two
/// dimensions, with digits scrambled by the seed. Every box of area 2^-k whose sides are powers of 1/2
/// contains one of the first 2^k points of a seed.
void light_samples(std::uint32_t index, std::span<const std::uint32_t> seeds, Lanes& u, Lanes& v);

/// Returns the index in another order, in which each block of a power of two of consecutive indices is a
/// block again (Burley, 2020). light_samples() of indices and of shuffled ones have nothing in common.
[[nodiscard]] std::uint32_t shuffled(std::uint32_t index);

/// Multiples of these numbers, the golden ratios of the plane, fill a square evenly (Roberts, 2018): 1 / g
/// and 1 / g^2 for g^3 = g + 1.
inline constexpr glm::dvec2 kEvenSteps(0.7548776662466927, 0.5698402909980532);
/// Returns the `index`-th point of [0, 1)^2 of this sequence, which light_samples() have nothing in common
/// with.
[[nodiscard]] glm::vec2 even_point(std::size_t index);

/// Returns the number of light samples for a light of this angular radius: `most` from 0.2 radians on, fewer
/// for smaller lights, because their soft shadows are narrower, and twice as many from 0.8 radians on,
/// because such lights are much wider than the lobes that see them.
[[nodiscard]] std::uint32_t light_sample_count(float angular_radius, std::uint32_t most);

/// Returns the seed of a point for a light; equal arguments give equal seeds.
[[nodiscard, gnu::always_inline]] inline std::uint32_t sample_seed(std::uint32_t point, std::uint32_t light) {
    return mixed(mixed(point) + 0x9E3779B9U * light);
}

}  // namespace nicol
