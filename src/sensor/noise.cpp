// SPDX-License-Identifier: MIT
#include "sensor/noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nicol {
namespace {

/// Returns the natural logarithm of x > 0: x = m 2^e with m in [1/2, 1), and ln m = 2 artanh((m - 1) / (m +
/// 1)).
double logarithm(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const double ratio = (mantissa - 1) / (mantissa + 1);
    double sum = 0;
    for (int i = 31; i > 0; i -= 2) sum = 1.0 / i + ratio * ratio * sum;
    return exponent * std::numbers::ln2 + 2 * ratio * sum;
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
    for (int round = 0; round < 10; ++round) {
        const std::uint64_t first = std::uint64_t{0xD2511F53} * counter[0];
        const std::uint64_t second = std::uint64_t{0xCD9E8D57} * counter[2];
        counter = {static_cast<std::uint32_t>(second >> 32) ^ counter[1] ^ key[0],
                   static_cast<std::uint32_t>(second),
                   static_cast<std::uint32_t>(first >> 32) ^ counter[3] ^ key[1],
                   static_cast<std::uint32_t>(first)};
        key[0] += 0x9E3779B9;
        key[1] += 0xBB67AE85;
    }
    return counter;
}

std::array<double, 2> uniform_pair(std::uint64_t seed, std::uint64_t frame, std::uint32_t pixel,
                                   NoiseOf purpose) {
    const auto low = [](std::uint64_t x) { return static_cast<std::uint32_t>(x); };
    const auto high = [](std::uint64_t x) { return static_cast<std::uint32_t>(x >> 32); };
    const std::array<std::uint32_t, 4> bits = philox(
        {pixel, low(frame), high(frame), static_cast<std::uint32_t>(purpose)}, {low(seed), high(seed)});
    const auto uniform = [](std::uint32_t upper, std::uint32_t lower) {
        const std::uint64_t whole = (std::uint64_t{upper} << 20) | (lower >> 12);  // 52 bits
        return (static_cast<double>(whole) + 0.5) * 0x1p-52;
    };
    return {uniform(bits[0], bits[1]), uniform(bits[2], bits[3])};
}

double normal_quantile(double u) {
    const double q = u - 0.5;
    if (std::abs(q) <= 0.425) {
        const double r = 0.180625 - q * q;
        return q * (((5.9109374720e1 * r + 1.5929113202e2) * r + 5.0434271938e1) * r + 3.3871327179) /
               (((6.7187563600e1 * r + 7.8757757664e1) * r + 1.7895169469e1) * r + 1);
    }
    double r = std::sqrt(-logarithm(std::min(u, 1 - u)));
    double z = 0;
    if (r <= 5) {
        r -= 1.6;
        z = (((1.7023821103e-1 * r + 1.3067284816) * r + 2.7568153900) * r + 1.4234372777) /
            ((1.2021132975e-1 * r + 7.3700164250e-1) * r + 1);
    } else {
        r -= 5;
        z = (((1.7337203997e-2 * r + 4.2868294337e-1) * r + 3.0812263860) * r + 6.6579051150) /
            ((1.2258202635e-2 * r + 2.4197894225e-1) * r + 1);
    }
    return q < 0 ? -z : z;
}

double poisson_quantile(double u, double mean) {
    if (mean < 30) return poisson_by_sum(u, mean);
    const double w = normal_quantile(u);
    const double root = std::sqrt(mean);
    const double third = w * w / 6 + 1.0 / 3;
    const double fourth = -(w * w + 2) * w / 72 / root;
    const double fifth = ((w * w / 270 + 7.0 / 810) * w * w - 8.0 / 405) / mean;
    return std::max(0.0, std::floor(mean + root * w + third + fourth + fifth));
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

}  // namespace nicol
