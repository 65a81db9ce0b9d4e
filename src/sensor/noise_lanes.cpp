// SPDX-License-Identifier: MIT
#include "sensor/noise_lanes.hpp"

#include "sensor/noise_formulas.hpp"
#include "simd/dispatch.hpp"

namespace nicol {
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
    for (std::size_t i = 0; i < kNoiseLanes; ++i) out[i] = central_normal_quantile(u[i] - 0.5);
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
        if (std::abs(given[i] - 0.5) > kCentralQuantile) u[i] = normal_quantile(given[i]);
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
