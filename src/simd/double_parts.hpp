// SPDX-License-Identifier: MIT
// Parts of single-precision lanes as vectors of doubles, for steps in which single precision loses too many
// digits.
#pragma once

#include <cstddef>

#include "simd/double_vectors.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Parts for the baseline, for AVX2 and for AVX-512.
using TwoDoubles = DoubleVectors<2>::Vector;
using FourDoubles = DoubleVectors<4>::Vector;
using EightDoubles = DoubleVectors<8>::Vector;

/// Number of lanes in a part.
template <class Number>
inline constexpr std::size_t kDoublePart = sizeof(Number) / sizeof(double);

/// Loads the part that begins at lane `first`.
template <class Number>
[[gnu::always_inline]] inline void load_doubles(const Lanes& from, std::size_t first, Number& to) {
    using Floats [[gnu::vector_size(sizeof(Number) / 2)]] = float;
    Floats part;
    __builtin_memcpy(&part, from.value.data() + first, sizeof part);
    to = __builtin_convertvector(part, Number);
}
template <class Number>
[[gnu::always_inline]] inline void store_doubles(const Number& from, std::size_t first, Lanes& to) {
    using Floats [[gnu::vector_size(sizeof(Number) / 2)]] = float;
    const Floats part = __builtin_convertvector(from, Floats);
    __builtin_memcpy(to.value.data() + first, &part, sizeof part);
}

}  // namespace nicol
