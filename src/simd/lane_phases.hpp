// SPDX-License-Identifier: MIT
// Cosines and sines of multiples of an angle in each of sixteen lanes.
#pragma once

#include <array>
#include <cstddef>

#include "simd/lanes.hpp"

namespace nicol {

/// Double-precision numbers of sixteen vertices, for steps in which single precision loses too many digits.
struct alignas(64) DoubleLanes {
    std::array<double, kLanes> value;
};

/// Computes cosines[m] and sines[m] of m times the angles with these cosines and sines, for m < count. High
/// multiples keep their digits.
void raise_phases(const DoubleLanes& cosine, const DoubleLanes& sine, std::size_t count, Lanes* cosines,
                  Lanes* sines);

}  // namespace nicol
