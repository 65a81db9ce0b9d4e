// SPDX-License-Identifier: MIT
#include "shading/light_samples.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <glm/common.hpp>

#include "simd/dispatch.hpp"
#include "simd/mixed_bits.hpp"

namespace nicol {
namespace {

// Returns Sobol's second dimension, a binary fraction whose first bit is the lowest. The first dimension is
// the index itself.
std::uint32_t sobol(std::uint32_t index) {
    std::uint32_t out = 0;
    for (std::uint32_t direction = 1; index != 0; index >>= 1, direction ^= direction << 1)
        if ((index & 1) != 0) out ^= direction;
    return out;
}

using LaneBits [[gnu::vector_size(64)]] = std::uint32_t;

// Converts the first 24 bits to fractions below 1.
[[gnu::always_inline]] inline void put_fractions(const LaneBits& bits, Lanes& out) {
    using Signed [[gnu::vector_size(64)]] = std::int32_t;
    using Number [[gnu::vector_size(64)]] = float;
    const auto whole = reinterpret_cast<Signed>(bits >> 8);
    const Number fractions = __builtin_convertvector(whole, Number) * 0x1p-24F;
    std::memcpy(&out, &fractions, sizeof fractions);
}

template <class Bits>
[[gnu::always_inline]] inline void reverse(Bits& x) {
    x = (x >> 1 & 0x55555555U) | (x & 0x55555555U) << 1;
    x = (x >> 2 & 0x33333333U) | (x & 0x33333333U) << 2;
    x = (x >> 4 & 0x0F0F0F0FU) | (x & 0x0F0F0F0FU) << 4;
    x = (x >> 8 & 0x00FF00FFU) | (x & 0x00FF00FFU) << 8;
    x = x >> 16 | x << 16;
}

// Applies Owen's scrambling to a binary fraction whose first bit is the lowest, by Laine and Karras' hash
// (2011). The seed and the preceding bits determine whether a bit is flipped. The result's first bit is the
// highest.
template <class Bits>
[[gnu::always_inline]] inline void scramble(std::uint32_t fraction, const Bits& seeds, Bits& x) {
    x = fraction + seeds;
    x ^= x * 0x6C50B47CU;
    x ^= x * 0xB82F1E52U;
    x ^= x * 0xC7AFE638U;
    x ^= x * 0x8D22F6E6U;
    reverse(x);
}

// Scrambles both dimensions. `second`: fraction whose first bit is the lowest.
[[gnu::always_inline]] inline void scramble_all(std::uint32_t index, std::uint32_t second,
                                                const std::array<std::uint32_t, kLanes>& seeds, Lanes& u,
                                                Lanes& v) {
    LaneBits seed, bits;
    std::memcpy(&seed, seeds.data(), sizeof seed);
    scramble(index, seed, bits);
    put_fractions(bits, u);
    mix(seed);
    scramble(second, seed, bits);
    put_fractions(bits, v);
}

}  // namespace

void light_samples(std::uint32_t index, std::span<const std::uint32_t> seeds, Lanes& u, Lanes& v) {
    std::array<std::uint32_t, kLanes> all;
    for (std::size_t i = 0; i < kLanes; ++i) all[i] = seeds[std::min(i, seeds.size() - 1)];
    dispatch<scramble_all>(index, sobol(index), all, u, v);
}

std::uint32_t shuffled(std::uint32_t index) {
    constexpr std::uint32_t seed = 0x68BC21EBU;
    std::uint32_t out = 0;
    reverse(index);
    scramble(index, seed, out);
    return out;
}

glm::vec2 even_point(std::size_t index) {
    const glm::dvec2 point = glm::fract(0.5 + static_cast<double>(index) * kEvenSteps);
    return glm::min(glm::vec2(point), 1 - 0x1p-24F);
}

std::uint32_t light_sample_count(float angular_radius, std::uint32_t most) {
    constexpr float wide = 0.2F, widest = 0.8F;
    constexpr std::uint32_t fewest = 4;  // a number at which the first samples are stratified
    if (angular_radius <= 0) return 1;
    const float small = std::min(1.0F, angular_radius / wide);
    const float large = std::clamp((angular_radius - widest / 2) / (widest / 2), 0.0F, 1.0F);
    const float wanted = (small + large) * static_cast<float>(most);
    const auto strata = static_cast<std::uint32_t>(std::ceil(wanted / fewest));
    return std::min(fewest * strata, std::max(most, static_cast<std::uint32_t>(wanted)));
}

}  // namespace nicol
