// SPDX-License-Identifier: MIT
#include "reference/low_discrepancy.hpp"

#include <cmath>

namespace nicol {
namespace {

std::uint32_t reversed(std::uint32_t x) {
    x = (x >> 16) | (x << 16);
    x = ((x >> 8) & 0x00FF00FFU) | ((x & 0x00FF00FFU) << 8);
    x = ((x >> 4) & 0x0F0F0F0FU) | ((x & 0x0F0F0F0FU) << 4);
    x = ((x >> 2) & 0x33333333U) | ((x & 0x33333333U) << 2);
    return ((x >> 1) & 0x55555555U) | ((x & 0x55555555U) << 1);
}

/// Returns Sobol's second dimension, most significant bit first. Column k of its matrix is row k of Pascal's
/// triangle modulo 2, so each column is the previous one xor itself moved by one bit.
std::uint32_t sobol_second(std::uint32_t index) {
    std::uint32_t result = 0;
    for (std::uint32_t column = 1U << 31; index != 0; index >>= 1, column ^= column >> 1) {
        if ((index & 1U) != 0) result ^= column;
    }
    return result;
}

/// Returns Owen's scrambling of a number given with its bits reversed. Whether a bit flips depends only on
/// the seed and on the bits below it. Every step here has this property: sums and products carry upwards
/// only, and the multipliers in the xor steps are even, so that no bit decides about itself. The numbers are
/// digits of square roots.
std::uint32_t scrambled_reversed(std::uint32_t x, std::uint64_t seed) {
    const auto low = static_cast<std::uint32_t>(seed);
    const auto high = static_cast<std::uint32_t>(seed >> 32);
    x += low;
    x ^= x * 0x3C6EF372U;
    x *= high | 1U;
    x ^= x * 0xA54FF53AU;
    x += high;
    x ^= x * 0x510E527EU;
    x *= 0x5BE0CD19U;
    x ^= x * 0x9B05688CU;
    return x;
}

/// Returns `bits` / 2^32, with the lower digits taken from `rest`.
double fraction(std::uint32_t bits, std::uint64_t rest) {
    const std::uint64_t digits = (std::uint64_t{bits} << 20) | (rest >> 44);
    return std::ldexp(static_cast<double>(digits), -52);
}

}  // namespace

std::uint64_t mixed(std::uint64_t a, std::uint64_t b) {
    std::uint64_t x = a * 0xBB67AE8584CAA73BU + b + 0x9E3779B97F4A7C15U;
    for (int round = 0; round < 3; ++round) {
        x ^= x >> 32;
        x *= 0x6A09E667F3BCC909U;
    }
    return x ^ (x >> 32);
}

glm::dvec2 LowDiscrepancy::point(std::uint32_t index, std::uint32_t stream) const {
    const std::uint64_t key = mixed(seed_, stream);
    // Each stream takes the points in its own order, so that streams do not correlate. The orders are
    // scrambled, because an aligned run of 2^k points then stays an aligned run.
    const std::uint32_t order = reversed(scrambled_reversed(reversed(index), key));
    const std::uint64_t rest = mixed(key, index);
    const std::uint32_t x = reversed(scrambled_reversed(order, mixed(key, ~std::uint64_t{1})));
    const std::uint32_t y =
        reversed(scrambled_reversed(reversed(sobol_second(order)), mixed(key, ~std::uint64_t{2})));
    return {fraction(x, rest), fraction(y, mixed(rest, 1))};
}

}  // namespace nicol
