// SPDX-License-Identifier: MIT
#include "sensor/noise.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Formulas that functions of one number and of lanes share, so that both give the same bits.

/// Distance from 1/2 up to which the central formula of the normal quantile holds.
constexpr double kCentralQuantile = 0.425;
/// Mean from which on large_poisson_quantile() holds.
constexpr double kLargeMean = 30;

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
constexpr int kPhiloxRounds = 10;
/// Steps of Philox's keys from round to round.
constexpr std::uint32_t kPhiloxStepA = 0x9E3779B9;
constexpr std::uint32_t kPhiloxStepB = 0xBB67AE85;

/// Returns the odd multiple of 2^-53 in (0, 1) of 52 random bits.
[[gnu::always_inline]] inline double uniform_of(std::uint32_t upper, std::uint32_t lower) {
    const std::uint64_t whole = (std::uint64_t{upper} << 20) | (lower >> 12);
    return (static_cast<double>(static_cast<std::int64_t>(whole)) + 0.5) * 0x1p-52;
}

/// Smallest distance from 0 and 1 at which near_normal_quantile() holds: a little more than exp(-25).
constexpr double kNearQuantile = 1.4e-11;

/// Returns Poisson's quantile by the normal quantile w of the same number.
[[gnu::always_inline]] inline double large_poisson_quantile(double w, double mean) {
    const double root = std::sqrt(mean);
    const double third = w * w / 6 + 1.0 / 3;
    const double fourth = -(w * w + 2) * w / 72 / root;
    const double fifth = ((w * w / 270 + 7.0 / 810) * w * w - 8.0 / 405) / mean;
    return std::max(0.0, std::floor(mean + root * w + third + fourth + fifth));
}

constexpr std::array<double, 16> kInverseOddNumbers = [] {
    std::array<double, 16> inverse{};
    for (std::size_t i = 0; i < inverse.size(); ++i) inverse[i] = 1.0 / static_cast<double>(2 * i + 1);
    return inverse;
}();

/// Returns the sum of the powers of x, times the inverse odd numbers. Without a loop, because compilers do
/// not vectorise a loop of loops.
template <std::size_t... i>
[[gnu::always_inline]] inline double odd_series(double x, std::index_sequence<i...>) {
    double sum = 0;
    ((sum = kInverseOddNumbers[sizeof...(i) - 1 - i] + x * sum), ...);
    return sum;
}

/// Returns the natural logarithm of a normal number x > 0: x = m 2^e with m in [1/2, 1), and ln m = 2
/// artanh((m - 1) / (m + 1)).
[[gnu::always_inline]] inline double logarithm(double x) {
    const auto bits = std::bit_cast<std::uint64_t>(x);
    const auto exponent = static_cast<std::int32_t>(bits >> 52) - 1022;
    const auto mantissa = std::bit_cast<double>((bits & 0x000FFFFFFFFFFFFF) | 0x3FE0000000000000);
    const double ratio = (mantissa - 1) / (mantissa + 1);
    const double sum = odd_series(ratio * ratio, std::make_index_sequence<kInverseOddNumbers.size()>());
    return exponent * std::numbers::ln2 + 2 * ratio * sum;
}

/// Returns the normal quantile of u, at least kNearQuantile from 0 and 1. Both of its formulas are quotients,
/// and one division serves both.
[[gnu::always_inline]] inline double near_normal_quantile(double u) {
    const double q = u - 0.5;
    const bool central = std::abs(q) <= kCentralQuantile;
    const double c = 0.180625 - q * q;
    const double r = std::sqrt(-logarithm(std::min(u, 1 - u))) - 1.6;
    const double above =
        central ? q * (((5.9109374720e1 * c + 1.5929113202e2) * c + 5.0434271938e1) * c + 3.3871327179)
                : ((1.7023821103e-1 * r + 1.3067284816) * r + 2.7568153900) * r + 1.4234372777;
    const double below = central ? ((6.7187563600e1 * c + 7.8757757664e1) * c + 1.7895169469e1) * c + 1
                                 : (1.2021132975e-1 * r + 7.3700164250e-1) * r + 1;
    const double z = above / below;
    return !central && q < 0 ? -z : z;
}

/// Returns the normal quantile of u nearer to 0 or 1 than kNearQuantile.
double far_normal_quantile(double u) {
    const double r = std::sqrt(-logarithm(std::min(u, 1 - u))) - 5;
    const double z = (((1.7337203997e-2 * r + 4.2868294337e-1) * r + 3.0812263860) * r + 6.6579051150) /
                     ((1.2258202635e-2 * r + 2.4197894225e-1) * r + 1);
    return u < 0.5 ? -z : z;
}

/// Returns the quantile by summing the probabilities of 0, 1, 2 ... For means up to 30 their sum exceeds 1 -
/// 2^-53 far below the limit.
double poisson_by_sum(double u, double mean) {
    constexpr int limit = 120;
    double probability = decay(mean);
    double sum = probability;
    int k = 0;
    while (u > sum && k < limit) {
        ++k;
        probability *= mean / k;
        sum += probability;
    }
    return k;
}

}  // namespace

// The series of exp(-x / 64), squared six times.
double decay(double x) {
    const double step = -x / 64;
    double sum = 1;
    for (int i = 16; i > 0; --i) sum = 1 + step / i * sum;
    for (int i = 0; i < 6; ++i) sum *= sum;
    return sum;
}

std::array<std::uint32_t, 4> philox(std::array<std::uint32_t, 4> counter, std::array<std::uint32_t, 2> key) {
    for (int round = 0; round < kPhiloxRounds; ++round) {
        philox_round(counter[0], counter[1], counter[2], counter[3], key[0], key[1]);
        key[0] += kPhiloxStepA;
        key[1] += kPhiloxStepB;
    }
    return counter;
}

std::array<double, 2> uniform_pair(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel,
                                   NoiseOf purpose) {
    const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
    const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); };
    const std::array<std::uint32_t, 4> bits = philox(
        {pixel, low(frame), high(frame), static_cast<std::uint32_t>(purpose)}, {low(seed), high(seed)});
    return {uniform_of(bits[0], bits[1]), uniform_of(bits[2], bits[3])};
}

double normal_quantile(double u) {
    return std::min(u, 1 - u) < kNearQuantile ? far_normal_quantile(u) : near_normal_quantile(u);
}

double poisson_quantile(double u, double mean) {
    if (mean < kLargeMean) return poisson_by_sum(u, mean);
    return large_poisson_quantile(normal_quantile(u), mean);
}

std::array<double, 2> cosine_and_sine(double angle) {
    const double square = angle * angle;
    double cosine = 1;
    double sine = 1;
    for (int i = 24; i > 0; i -= 2) {
        cosine = 1 - square / (i * (i - 1)) * cosine;
        sine = 1 - square / (i * (i + 1)) * sine;
    }
    return {cosine, angle * sine};
}

namespace {

using Words = std::array<std::uint32_t, kNoiseLanes>;

[[gnu::always_inline]] inline void draw(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel,
                                        std::uint32_t purpose, NoiseLanes& first, NoiseLanes& second) {
    Words a, b, c, d;
    for (std::size_t i = 0; i < kNoiseLanes; ++i) {
        a[i] = pixel + static_cast<std::uint32_t>(i);
        b[i] = static_cast<std::uint32_t>(frame);
        c[i] = static_cast<std::uint32_t>(frame >> 32);
        d[i] = purpose;
    }
    auto key_a = static_cast<std::uint32_t>(seed);
    auto key_b = static_cast<std::uint32_t>(seed >> 32);
    for (int round = 0; round < kPhiloxRounds; ++round) {
        for (std::size_t i = 0; i < kNoiseLanes; ++i) philox_round(a[i], b[i], c[i], d[i], key_a, key_b);
        key_a += kPhiloxStepA;
        key_b += kPhiloxStepB;
    }
    for (std::size_t i = 0; i < kNoiseLanes; ++i) {
        first[i] = uniform_of(a[i], b[i]);
        second[i] = uniform_of(c[i], d[i]);
    }
}

[[gnu::always_inline]] inline void quantiles(const NoiseLanes& u, NoiseLanes& out) {
    for (std::size_t i = 0; i < kNoiseLanes; ++i) out[i] = near_normal_quantile(u[i]);
}

[[gnu::always_inline]] inline void large_poisson(const NoiseLanes& w, NoiseLanes& mean) {
    for (std::size_t i = 0; i < kNoiseLanes; ++i) mean[i] = large_poisson_quantile(w[i], mean[i]);
}

}  // namespace

void uniform_pairs(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel, NoiseOf purpose,
                   NoiseLanes& first, NoiseLanes& second) {
    dispatch<draw>(seed, frame, pixel, static_cast<std::uint32_t>(purpose), first, second);
}

void to_normal(NoiseLanes& u) {
    const NoiseLanes given = u;
    dispatch<quantiles>(given, u);
    for (std::size_t i = 0; i < kNoiseLanes; ++i)
        if (std::min(given[i], 1 - given[i]) < kNearQuantile) u[i] = far_normal_quantile(given[i]);
}

void to_poisson(const NoiseLanes& u, NoiseLanes& mean) {
    NoiseLanes normal = u;
    to_normal(normal);
    const NoiseLanes given = mean;
    dispatch<large_poisson>(normal, mean);
    for (std::size_t i = 0; i < kNoiseLanes; ++i)
        if (given[i] < kLargeMean) mean[i] = poisson_quantile(u[i], given[i]);
}

}  // namespace nicol
