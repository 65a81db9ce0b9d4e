// SPDX-License-Identifier: MIT
#include "shading/light_places.hpp"

#include <algorithm>

namespace nicol {
namespace {

// Steele and Vigna's mixer of 32 bits.
std::uint32_t mixed(std::uint32_t x) {
    x = (x ^ (x >> 16)) * 0x21F0AAADU;
    x = (x ^ (x >> 15)) * 0x735A2D97U;
    return x ^ (x >> 15);
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

// 24 bits, below 1.
float fraction(std::uint32_t bits) {
    return static_cast<float>(bits >> 8) * 0x1p-24F;
}

}  // namespace

std::uint32_t place_seed(std::uint32_t point, std::uint32_t light) {
    return mixed(mixed(point) + 0x9E3779B9U * light);
}

void light_places(std::uint32_t index, std::span<const std::uint32_t> seeds, Lanes& u, Lanes& v) {
    const std::uint32_t first = reversed(index);
    const std::uint32_t second = sobol(index);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::uint32_t seed = seeds[std::min(i, seeds.size() - 1)];
        u[i] = fraction(first ^ seed);
        v[i] = fraction(second ^ mixed(seed));
    }
}

}  // namespace nicol
