// SPDX-License-Identifier: MIT
// Lanes in parts as wide as the registers of an instruction set, for functions that choose between numbers:
// GCC does that one number at a time in vectors that are wider.
#pragma once

#include <cstddef>

#include "simd/lanes.hpp"

namespace nicol {

/// The parts of the baseline, of AVX2 and of AVX-512.
using FourLanes [[gnu::vector_size(16)]] = float;
using EightLanes [[gnu::vector_size(32)]] = float;
using AllLanes [[gnu::vector_size(64)]] = float;

template <class Number>
inline constexpr std::size_t kPart = sizeof(Number) / sizeof(float);

/// The part from lane `first` on.
template <class Number>
[[gnu::always_inline]] inline void load_part(const Lanes& from, std::size_t first, Number& to) {
    __builtin_memcpy(&to, from.value.data() + first, sizeof to);
}
template <class Number>
[[gnu::always_inline]] inline void store_part(const Number& from, std::size_t first, Lanes& to) {
    __builtin_memcpy(to.value.data() + first, &from, sizeof from);
}

}  // namespace nicol
