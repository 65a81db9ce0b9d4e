// SPDX-License-Identifier: MIT
// Which samples of a light with a size light a point.
#pragma once

#include <cstdint>
#include <span>

#include "simd/lanes.hpp"

namespace nicol {

/// For each of up to sixteen points, given by its seed, a point of [0, 1)^2: the `index`-th of Sobol's first
/// two dimensions, with digits scrambled by the seed. Of the first 2^k points of a seed one lies in every box
/// of area 2^-k whose sides are powers of 1/2.
void light_samples(std::uint32_t index, std::span<const std::uint32_t> seeds, Lanes& u, Lanes& v);

/// A seed of a point for a light; equal arguments give equal seeds.
[[nodiscard]] std::uint32_t sample_seed(std::uint32_t point, std::uint32_t light);

}  // namespace nicol
