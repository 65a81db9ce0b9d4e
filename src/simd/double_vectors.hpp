// SPDX-License-Identifier: MIT
// Doubles side by side as the compiler's own vectors, as many as an instruction set has in a register.
#pragma once

namespace nicol {

template <int Width>
struct DoubleVectors {
    typedef double Vector __attribute__((vector_size(8 * Width)));
    typedef double Unaligned __attribute__((vector_size(8 * Width), aligned(8), may_alias));
    typedef long long Mask __attribute__((vector_size(8 * Width)));
};

/// Width doubles anywhere in memory.
template <int Width>
[[gnu::always_inline]] inline const typename DoubleVectors<Width>::Unaligned& at(const double* p) {
    return *reinterpret_cast<const typename DoubleVectors<Width>::Unaligned*>(p);
}
template <int Width>
[[gnu::always_inline]] inline typename DoubleVectors<Width>::Unaligned& at(double* p) {
    return *reinterpret_cast<typename DoubleVectors<Width>::Unaligned*>(p);
}

}  // namespace nicol
