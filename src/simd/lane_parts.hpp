// SPDX-License-Identifier: MIT
// Parts of lanes as wide as the registers of an instruction set. Functions that select between numbers use
// parts because GCC selects one number at a time in wider vectors. Parts of doubles serve steps in which
// single precision loses too many digits.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>

#include "simd/double_vectors.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Parts for the baseline, for AVX2 and for AVX-512.
using FourLanes [[gnu::vector_size(16)]] = float;
using EightLanes [[gnu::vector_size(32)]] = float;
using AllLanes [[gnu::vector_size(64)]] = float;
using TwoDoubles = DoubleVectors<2>::Vector;
using FourDoubles = DoubleVectors<4>::Vector;
using EightDoubles = DoubleVectors<8>::Vector;

/// Number of lanes in a part.
template <class Number>
inline constexpr std::size_t kPart = sizeof(Number) /
                                     sizeof(std::remove_cvref_t<decltype(std::declval<Number&>()[0])>);

/// Loads the part that begins at lane `first`.
template <class Number>
[[gnu::always_inline]] inline void load_part(const Lanes& from, std::size_t first, Number& to) {
    using Floats [[gnu::vector_size(kPart<Number> * sizeof(float))]] = float;
    Floats part;
    __builtin_memcpy(&part, from.value.data() + first, sizeof part);
    to = __builtin_convertvector(part, Number);
}
template <class Number>
[[gnu::always_inline]] inline void store_part(const Number& from, std::size_t first, Lanes& to) {
    using Floats [[gnu::vector_size(kPart<Number> * sizeof(float))]] = float;
    const Floats part = __builtin_convertvector(from, Floats);
    __builtin_memcpy(to.value.data() + first, &part, sizeof part);
}

}  // namespace nicol
