// SPDX-License-Identifier: MIT
// Multiples of an angle in each of sixteen lanes.
#pragma once

#include <array>
#include <cstddef>

#include "simd/lanes.hpp"

namespace nicol {

/// One number of each of sixteen vertices, where single precision loses too much.
struct alignas(64) DoubleLanes {
    std::array<double, kLanes> value;
};

/// cosines[m] and sines[m] of m times the angles with these cosines and sines, for m < count. High multiples
/// keep their digits.
void raise_phases(const DoubleLanes& cosine, const DoubleLanes& sine, std::size_t count, Lanes* cosines,
                  Lanes* sines);

}  // namespace nicol
