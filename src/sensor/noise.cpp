// SPDX-License-Identifier: MIT
#include "sensor/noise.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "sensor/noise_formulas.hpp"

namespace nicol {
namespace {

constexpr std::array<double, 16> kInverseOddNumbers = [] {
    std::array<double, 16> inverse{};
    for (std::size_t i = 0; i < inverse.size(); ++i) inverse[i] = 1.0 / static_cast<double>(2 * i + 1);
    return inverse;
}();

/// Returns the natural logarithm of x > 0: x = m 2^e with m in [1/2, 1), and ln m = 2 artanh((m - 1) / (m +
/// 1)).
double logarithm(double x) {
    int exponent = 0;
    const double mantissa = std::frexp(x, &exponent);
    const double ratio = (mantissa - 1) / (mantissa + 1);
    double sum = 0;
    for (std::size_t i = kInverseOddNumbers.size(); i-- > 0;)
        sum = kInverseOddNumbers[i] + ratio * ratio * sum;
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
    const double q = u - 0.5;
    if (std::abs(q) <= kCentralQuantile) return central_normal_quantile(q);
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

}  // namespace nicol
