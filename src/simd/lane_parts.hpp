// SPDX-License-Identifier: MIT
// Parts of lanes as wide as the registers of an instruction set. Functions that select between numbers use
// parts because GCC selects one number at a time in wider vectors.
#pragma once

#include <cstddef>

#include "simd/lanes.hpp"

namespace nicol {

/// Parts for the baseline, for AVX2 and for AVX-512.
using FourLanes [[gnu::vector_size(16)]] = float;
using EightLanes [[gnu::vector_size(32)]] = float;
using AllLanes [[gnu::vector_size(64)]] = float;

template <class Number>
inline constexpr std::size_t kPart = sizeof(Number) / sizeof(float);

/// Loads the part that begins at lane `first`.
template <class Number>
[[gnu::always_inline]] inline void load_part(const Lanes& from, std::size_t first, Number& to) {
    __builtin_memcpy(&to, from.value.data() + first, sizeof to);
}
template <class Number>
[[gnu::always_inline]] inline void store_part(const Number& from, std::size_t first, Lanes& to) {
    __builtin_memcpy(to.value.data() + first, &from, sizeof from);
}

}  // namespace nicol
