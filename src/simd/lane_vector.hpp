// SPDX-License-Identifier: MIT
// Lanes as the compiler's own vectors, which stay in registers, whereas arrays go through memory.
#pragma once

#include <cstdint>

#include "simd/lanes.hpp"

namespace nicol {

using LaneVector [[gnu::vector_size(64), gnu::may_alias]] = float;
using FixedVector [[gnu::vector_size(32), gnu::may_alias]] = std::int16_t;
using IntVector [[gnu::vector_size(64), gnu::may_alias]] = std::int32_t;

/// Scale of 16-bit numbers: multiples of 1 / kFixedOne, -2 to 2 in steps of 6.1e-5.
inline constexpr float kFixedOne = 16384.0F;

// Functions inlined into functions of every instruction set. Loaded 16-bit numbers are not scaled: they are
// kFixedOne times too large.
[[gnu::always_inline]] inline void load(const Lanes* from, LaneVector& to) {
    to = *reinterpret_cast<const LaneVector*>(from);
}
[[gnu::always_inline]] inline void load(const float* from, LaneVector& to) {
    to = *reinterpret_cast<const LaneVector*>(from);
}
[[gnu::always_inline]] inline void load(const std::int16_t* from, LaneVector& to) {
    to = __builtin_convertvector(*reinterpret_cast<const FixedVector*>(from), LaneVector);
}
// Factor of the numbers of load_pair(), which loads two 16-bit numbers side by side in each lane.
inline constexpr float kPairedOne = kFixedOne * 65536;
[[gnu::always_inline]] inline void load_pair(const std::int16_t* from, LaneVector& first,
                                             LaneVector& second) {
    const IntVector both = *reinterpret_cast<const IntVector*>(from);
    first = __builtin_convertvector(both << 16, LaneVector);
    second = __builtin_convertvector(both & ~0xFFFF, LaneVector);
}
[[gnu::always_inline]] inline void store(Lanes* to, const LaneVector& from) {
    *reinterpret_cast<LaneVector*>(to) = from;
}

}  // namespace nicol
