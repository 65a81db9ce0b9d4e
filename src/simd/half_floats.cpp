// SPDX-License-Identifier: MIT
#include "simd/half_floats.hpp"

#include <bit>
#include <cstddef>

#include "simd/dispatch.hpp"

#ifdef __x86_64__
#include <immintrin.h>
#endif

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

void convert(const float* from, std::uint16_t* to, std::size_t count) {
#pragma omp simd
    for (std::size_t i = 0; i < count; ++i) to[i] = half_of(from[i]);
}

#ifdef __x86_64__
// Converts by the instruction for it, which processors with InstructionSet::avx2 have.
[[gnu::target("avx2,f16c")]] void convert_f16c(const float* from, std::uint16_t* to, std::size_t count) {
    constexpr std::size_t lanes = 8;
    std::size_t done = 0;
    for (; done + lanes <= count; done += lanes) {
        const __m128i halves = _mm256_cvtps_ph(_mm256_loadu_ps(from + done), _MM_FROUND_TO_NEAREST_INT);
        _mm_storeu_si128(reinterpret_cast<__m128i*>(to + done), halves);
    }
    for (; done < count; ++done) to[done] = half_of(from[done]);
}
#endif

}  // namespace

void to_half(std::span<const float> from, std::span<std::uint16_t> to) {
#ifdef __x86_64__
    if (instruction_set() != InstructionSet::baseline)
        return convert_f16c(from.data(), to.data(), from.size());
#endif
    convert(from.data(), to.data(), from.size());
}

}  // namespace nicol
