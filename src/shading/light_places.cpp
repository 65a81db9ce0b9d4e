// SPDX-License-Identifier: MIT
#include "shading/light_places.hpp"

#include <algorithm>
#include <array>
#include <cstring>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Steele and Vigna's mixer of 32 bits.
template <class Bits>
[[gnu::always_inline]] inline void mix(Bits& x) {
    x = (x ^ (x >> 16)) * 0x21F0AAADU;
    x = (x ^ (x >> 15)) * 0x735A2D97U;
    x = x ^ (x >> 15);
}

std::uint32_t mixed(std::uint32_t x) {
    mix(x);
    return x;
}

// The bits of `index` as a binary fraction, the last bit first.
std::uint32_t reversed(std::uint32_t index) {
    std::uint32_t out = 0;
    for (std::uint32_t bit = 0x80000000U; index != 0; index >>= 1, bit >>= 1)
        if ((index & 1) != 0) out |= bit;
    return out;
}

// Sobol's second dimension.
std::uint32_t sobol(std::uint32_t index) {
    std::uint32_t out = 0;
    for (std::uint32_t direction = 0x80000000U; index != 0; index >>= 1, direction ^= direction >> 1)
        if ((index & 1) != 0) out ^= direction;
    return out;
}

using LaneBits [[gnu::vector_size(64)]] = std::uint32_t;

// The first 24 bits, below 1.
[[gnu::always_inline]] inline void put_fractions(const LaneBits& bits, Lanes& out) {
    using Signed [[gnu::vector_size(64)]] = std::int32_t;
    using Number [[gnu::vector_size(64)]] = float;
    const auto whole = reinterpret_cast<Signed>(bits >> 8);
    const Number fractions = __builtin_convertvector(whole, Number) * 0x1p-24F;
    std::memcpy(&out, &fractions, sizeof fractions);
}

[[gnu::always_inline]] inline void scramble(std::uint32_t first, std::uint32_t second,
                                            const std::array<std::uint32_t, kLanes>& seeds, Lanes& u,
                                            Lanes& v) {
    LaneBits bits;
    std::memcpy(&bits, seeds.data(), sizeof bits);
    put_fractions(bits ^ first, u);
    mix(bits);
    put_fractions(bits ^ second, v);
}

}  // namespace

std::uint32_t place_seed(std::uint32_t point, std::uint32_t light) {
    return mixed(mixed(point) + 0x9E3779B9U * light);
}

void light_places(std::uint32_t index, std::span<const std::uint32_t> seeds, Lanes& u, Lanes& v) {
    std::array<std::uint32_t, kLanes> all;
    for (std::size_t i = 0; i < kLanes; ++i) all[i] = seeds[std::min(i, seeds.size() - 1)];
    dispatch<scramble>(reversed(index), sobol(index), all, u, v);
}

}  // namespace nicol
