// SPDX-License-Identifier: MIT
// The exponential function, for single numbers and, within a few roundings, for vectors of lanes.
#pragma once

#include <cmath>
#include <concepts>
#include <cstdint>

namespace nicol {

template <std::floating_point Number>
[[gnu::always_inline]] inline void exponential(Number& x) {
    x = std::exp(x);
}

/// Replaces x by e^x for x from -87 to 0. Number: a vector of floats.
template <class Number>
[[gnu::always_inline]] inline void exponential(Number& x) {
    using Integer [[gnu::vector_size(sizeof(Number))]] = std::int32_t;
    // Adding the constant leaves no digits behind the point and puts the whole number into the last bits.
    constexpr float rounder = 12582912.0F;
    const Number shifted = x * 1.44269504F + rounder;
    const Number whole = shifted - rounder;
    // ln 2 is split in two parts. The first part is short enough for exact products.
    const Number r = (x - whole * 0.693359375F) + whole * 2.12194440e-4F;
    const Number rest =
        1.0F + r * (1.0F + r * (0.5F + r * (0.16666667F +
                                            r * (0.041666638F + r * (0.0083334519F + r * 0.0013929634F)))));
    const Integer power = (__builtin_convertvector(whole, Integer) + 127) << 23;
    x = rest * reinterpret_cast<Number>(power);
}

}  // namespace nicol
