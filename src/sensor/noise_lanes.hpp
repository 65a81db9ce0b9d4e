// SPDX-License-Identifier: MIT
// Random numbers of many pixels at once, with the bits of noise.hpp.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "sensor/noise.hpp"

namespace nicol {

/// Numbers of consecutive pixels.
inline constexpr std::size_t kNoiseLanes = 16;
using NoiseLanes = std::array<double, kNoiseLanes>;

/// Sets two arrays to uniform_pair() of the pixels from `pixel` on.
void uniform_pairs(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel, NoiseOf purpose,
                   NoiseLanes& first, NoiseLanes& second);

/// Replaces each number by its normal_quantile().
void to_normal(NoiseLanes& u);

/// Replaces each mean by the poisson_quantile() of u.
void to_poisson(const NoiseLanes& u, NoiseLanes& mean);

}  // namespace nicol
