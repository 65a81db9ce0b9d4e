// SPDX-License-Identifier: MIT
// Vectors of doubles in the compiler's own types, as wide as the registers of an instruction set.
#pragma once

namespace nicol {

template <int Width>
struct DoubleVectors {
    using Vector [[gnu::vector_size(8 * Width)]] = double;
    using Mask [[gnu::vector_size(8 * Width)]] = long long;
};

/// Copies between a vector and memory of any alignment. (Clang assumes a vector's own alignment for a
/// reference that a function returns, whatever its type says.)
template <class Vector>
[[gnu::always_inline]] inline void load_vector(const double* from, Vector& to) {
    __builtin_memcpy(&to, from, sizeof to);
}
template <class Vector>
[[gnu::always_inline]] inline void store_vector(double* to, const Vector& from) {
    __builtin_memcpy(to, &from, sizeof from);
}
template <class Vector>
[[gnu::always_inline]] inline void add_vector(double* to, const Vector& from) {
    Vector sum;
    load_vector(to, sum);
    sum += from;
    store_vector(to, sum);
}

}  // namespace nicol
