// SPDX-License-Identifier: MIT
#include "simd/half_floats.hpp"

#include <bit>
#include <cstddef>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

constexpr std::uint32_t kInfinity = 0x7f800000;
constexpr std::uint32_t kBeyond = 0x47800000;       // 65536
constexpr std::uint32_t kLeastNormal = 0x38800000;  // 2^-14

[[gnu::always_inline]] inline std::uint16_t half_of(float value) {
    const auto bits = std::bit_cast<std::uint32_t>(value);
    const std::uint32_t size = bits & 0x7fffffff;
    const std::uint32_t bounded = size < kBeyond ? size : kBeyond;
    // The last place of a sum with 2^13 times the value's power of two is that of a half, so the addition
    // rounds.
    const std::uint32_t exponent = (bounded > kLeastNormal ? bounded : kLeastNormal) & kInfinity;
    const std::uint32_t base = exponent + (std::uint32_t{13} << 23);
    const std::uint32_t significand =
        std::bit_cast<std::uint32_t>(std::bit_cast<float>(bounded) + std::bit_cast<float>(base)) - base;
    // The leading bit of a normal number's significand counts the exponent up by one.
    std::uint32_t half = ((exponent - kLeastNormal) >> 13) + significand;
    half = size > kInfinity ? 0x7e00 : half;
    return static_cast<std::uint16_t>(half | (bits >> 16 & 0x8000));
}

[[gnu::always_inline]] inline void convert(const float* from, std::uint16_t* to, std::size_t count) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) to[i] = half_of(from[i]);
}

}  // namespace

void to_half(std::span<const float> from, std::span<std::uint16_t> to) {
    dispatch<convert>(from.data(), to.data(), from.size());
}

}  // namespace nicol
