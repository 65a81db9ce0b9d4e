// SPDX-License-Identifier: MIT
// The loops of ShadowGrid.
#pragma once

#include <cstddef>
#include <cstdint>

#include "simd/lanes.hpp"
#include "visibility/shadow_grid.hpp"

namespace nicol {

/// Most slots of one component: 2 order + 1.
inline constexpr std::size_t kMostSlots = 2 * 64 + 1;

/// samples[4 column + image] on one row of a component with coefficients `in`.
void synthesize_row(const ShadowGrid::Component& component, const ShadowGrid::Slots& slots, std::size_t row,
                    std::size_t quarter, const Lanes* in, Lanes* samples);

/// Adds visibility times the pair `from` of the light `in` to the pair `to` of the light `out`.
void multiply_pair(const ShadowGrid::Pair& from, const ShadowGrid::Pair& to, const ShadowGrid::Slots& slots,
                   std::size_t rows, std::size_t quarter, const std::int16_t* samples, const Lanes* in,
                   Lanes* out);

}  // namespace nicol
