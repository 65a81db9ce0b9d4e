// SPDX-License-Identifier: MIT
// Formulas that noise.cpp and noise_lanes.cpp share, so that both give the same bits.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace nicol {

/// Distance from 1/2 up to which central_normal_quantile() holds.
inline constexpr double kCentralQuantile = 0.425;
/// Mean from which on large_poisson_quantile() holds.
inline constexpr double kLargeMean = 30;

/// One round of Philox 4x32 on a counter.
[[gnu::always_inline]] inline void philox_round(std::uint32_t& a, std::uint32_t& b, std::uint32_t& c,
                                                std::uint32_t& d, std::uint32_t key_a, std::uint32_t key_b) {
    const std::uint64_t first = std::uint64_t{0xD2511F53} * a;
    const std::uint64_t second = std::uint64_t{0xCD9E8D57} * c;
    a = static_cast<std::uint32_t>(second >> 32) ^ b ^ key_a;
    b = static_cast<std::uint32_t>(second);
    c = static_cast<std::uint32_t>(first >> 32) ^ d ^ key_b;
    d = static_cast<std::uint32_t>(first);
}
inline constexpr int kPhiloxRounds = 10;
/// Steps of Philox's keys from round to round.
inline constexpr std::uint32_t kPhiloxStepA = 0x9E3779B9;
inline constexpr std::uint32_t kPhiloxStepB = 0xBB67AE85;

/// Returns the odd multiple of 2^-53 in (0, 1) of 52 random bits.
[[gnu::always_inline]] inline double uniform_of(std::uint32_t upper, std::uint32_t lower) {
    const std::uint64_t whole = (std::uint64_t{upper} << 20) | (lower >> 12);
    return (static_cast<double>(static_cast<std::int64_t>(whole)) + 0.5) * 0x1p-52;
}

/// Returns the normal quantile of 1/2 + q.
[[gnu::always_inline]] inline double central_normal_quantile(double q) {
    const double r = 0.180625 - q * q;
    return q * (((5.9109374720e1 * r + 1.5929113202e2) * r + 5.0434271938e1) * r + 3.3871327179) /
           (((6.7187563600e1 * r + 7.8757757664e1) * r + 1.7895169469e1) * r + 1);
}

/// Returns Poisson's quantile by the normal quantile w of the same number.
[[gnu::always_inline]] inline double large_poisson_quantile(double w, double mean) {
    const double root = std::sqrt(mean);
    const double third = w * w / 6 + 1.0 / 3;
    const double fourth = -(w * w + 2) * w / 72 / root;
    const double fifth = ((w * w / 270 + 7.0 / 810) * w * w - 8.0 / 405) / mean;
    return std::max(0.0, std::floor(mean + root * w + third + fourth + fifth));
}

}  // namespace nicol
