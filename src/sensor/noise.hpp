// SPDX-License-Identifier: MIT
// Random numbers of a sensor's pixels, with the same bits on every machine, one by one and for many pixels
// at once.
//
// A number depends on the seed, the frame, the pixel and its purpose alone, so no thread needs another one's
// state. All functions use only operations that IEEE 754 rounds correctly (+ - * / and the square root): the
// C library's exp, log, sin and cos differ between machines in their last bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace nicol {

/// Purpose of random numbers, which keeps the streams of a pixel apart.
enum class NoiseOf : std::uint32_t {
    exposure,         ///< photons and electrons, read noise; new in each frame
    micro_polarizer,  ///< angle, extinction
    response,         ///< sensitivity, offset
    crosstalk,
};

/// Returns one block of Philox 4x32-10, the counter-based generator of Salmon et al. (2011).
[[nodiscard]] std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key);

/// Returns two independent numbers that are uniform in (0, 1): odd multiples of 2^-53.
[[nodiscard]] std::array<double, 2> uniform_pair(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel,
                                                 NoiseOf purpose);

/// Returns the quantile of the standard normal distribution for 0 < u < 1, to 2e-7 (AS 241's PPND7, Wichura
/// 1988).
[[nodiscard]] double normal_quantile(double u);

/// Returns the quantile of the Poisson distribution for 0 < u < 1 and a finite mean >= 0. From a mean of 30
/// on the quantile is Giles' expansion (2016), which is wrong by one for less than 1 of 10,000 u.
[[nodiscard]] double poisson_quantile(double u, double mean);

/// Returns exp(-x) for 0 <= x <= 30, to 1e-14 of it.
[[nodiscard]] double decay(double x);

/// Returns the cosine and the sine of an angle of at most 2 radians, to 1e-15.
[[nodiscard]] std::array<double, 2> cosine_and_sine(double angle);

/// Numbers of consecutive pixels.
inline constexpr std::size_t kNoiseLanes = 16;
using NoiseLanes = std::array<double, kNoiseLanes>;

/// Sets two arrays to uniform_pair() of the pixels from `pixel` on.
void uniform_pairs(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel, NoiseOf purpose,
                   NoiseLanes& first, NoiseLanes& second);

/// Replaces each number by its normal_quantile().
void to_normal(NoiseLanes& u);

/// Replaces each mean by the poisson_quantile() of u.
void to_poisson(const NoiseLanes& u, NoiseLanes& mean);

}  // namespace nicol
