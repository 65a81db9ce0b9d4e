// SPDX-License-Identifier: MIT
// Numbers that depend on others as if by chance.
#pragma once

#include <cstdint>

namespace nicol {

/// Mixes 32 bits by the function of Steele and Vigna. Bits: std::uint32_t, or a vector of it.
template <class Bits>
[[gnu::always_inline]] inline void mix(Bits& x) {
    x = (x ^ (x >> 16)) * 0x21F0AAADU;
    x = (x ^ (x >> 15)) * 0x735A2D97U;
    x = x ^ (x >> 15);
}

/// Returns the number after mix().
[[nodiscard]] inline std::uint32_t mixed(std::uint32_t x) {
    mix(x);
    return x;
}

}  // namespace nicol
