// SPDX-License-Identifier: MIT
// Tests of random numbers: the generator's published answers, and distributions against their definitions.
#include "sensor/noise.hpp"

#include "test.hpp"

using namespace nicol;

TEST_CASE("the generator gives the published answers of Philox 4x32-10") {
    using Block = std::array<std::uint32_t, 4>;
    constexpr std::uint32_t ones = 0xffffffff;
    CHECK(philox({0, 0, 0, 0}, {0, 0}) == Block{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8});
    CHECK(philox({ones, ones, ones, ones}, {ones, ones}) ==
          Block{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd});
    CHECK(philox({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}) ==
          Block{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1});
}

TEST_CASE("seed, frame, pixel and purpose give different numbers, all of them inside of 0 to 1") {
    const auto base = uniform_pair(1, 2, 3, NoiseOf::exposure);
    CHECK(base == uniform_pair(1, 2, 3, NoiseOf::exposure));
    for (const auto& other :
         {uniform_pair(2, 2, 3, NoiseOf::exposure), uniform_pair(1, 3, 3, NoiseOf::exposure),
          uniform_pair(1, 2, 4, NoiseOf::exposure), uniform_pair(1, 2, 3, NoiseOf::response),
          uniform_pair(1 + (std::uint64_t{1} << 32), 2, 3, NoiseOf::exposure),
          uniform_pair(1, 2 + (std::uint64_t{1} << 32), 3, NoiseOf::exposure)})
        CHECK(other != base);
    double sum = 0;
    for (std::uint32_t i = 0; i < 10000; ++i) {
        const auto u = uniform_pair(7, 0, i, NoiseOf::exposure);
        CHECK((u[0] > 0 && u[0] < 1 && u[1] > 0 && u[1] < 1));
        sum += u[0] + u[1];
    }
    CHECK(sum / 20000 == doctest::Approx(0.5).epsilon(0.01));
}

TEST_CASE("the normal quantile inverts the distribution from end to end") {
    for (const double u : {0x1p-53, 1e-12, 1e-6, 0.01, 0.07, 0.0751, 0.3, 0.5, 0.8, 0.99, 1 - 1e-9}) {
        const double z = normal_quantile(u);
        CHECK(0.5 * std::erfc(-z / std::numbers::sqrt2) == doctest::Approx(u).epsilon(1e-5));
    }
    CHECK(normal_quantile(0.5) == 0);
    CHECK(normal_quantile(0x1p-6) == -normal_quantile(1 - 0x1p-6));
}

TEST_CASE("Poisson's quantile inverts the distribution, but for one in 10,000 where it is an expansion") {
    for (const double mean : {0.0, 0.3, 4.0, 29.0, 31.0, 500.0}) {
        CAPTURE(mean);
        constexpr int steps = 20000;
        int wrong = 0;
        double below = 0, until = std::exp(-mean), term = until;  // P(n < k), P(n <= k)
        int k = 0;
        for (int i = 0; i < steps; ++i) {
            const double u = (i + 0.5) / steps;
            while (u > until) {
                term *= mean / ++k;
                below = until;
                until += term;
            }
            const double quantile = poisson_quantile(u, mean);
            if (quantile != k) ++wrong;
            CHECK(std::abs(quantile - k) <= 1);
        }
        CHECK(below < until);
        CHECK(wrong <= (mean < 30 ? 0 : 4));
    }
    CHECK(poisson_quantile(1 - 0x1p-53, 1e12) == doctest::Approx(1e12));
}

TEST_CASE("cosines and sines are those of the C library to 1e-15") {
    for (double angle = -2; angle <= 2; angle += 0.01) {
        const auto [cosine, sine] = cosine_and_sine(angle);
        CHECK(std::abs(cosine - std::cos(angle)) < 1e-15);
        CHECK(std::abs(sine - std::sin(angle)) < 1e-15);
    }
}

TEST_CASE("numbers of many pixels have the bits of those of each pixel") {
    for (const std::uint32_t pixel : {0U, 1000003U, 0xFFFFFFF0U}) {
        NoiseLanes first, second, mean;
        uniform_pairs(0x123456789ABCDEF0, 77, pixel, NoiseOf::response, first, second);
        NoiseLanes normal = second;
        to_normal(normal);
        for (std::size_t i = 0; i < kNoiseLanes; ++i)
            mean[i] = i % 3 == 0 ? 0.5 * static_cast<double>(i) : 29 + 7.0 * static_cast<double>(i * i);
        NoiseLanes poisson = mean;
        to_poisson(first, poisson);
        for (std::size_t i = 0; i < kNoiseLanes; ++i) {
            const std::array<double, 2> pair = uniform_pair(
                0x123456789ABCDEF0, 77, pixel + static_cast<std::uint32_t>(i), NoiseOf::response);
            CHECK(first[i] == pair[0]);
            CHECK(second[i] == pair[1]);
            CHECK(normal[i] == normal_quantile(pair[1]));
            CHECK(poisson[i] == poisson_quantile(pair[0], mean[i]));
        }
    }
    NoiseLanes ends{1e-16, 0.074, 0.0751, 0.5, 0.924, 0.926, 1 - 0x1p-53, 1e-30, 1.39e-11, 1.41e-11};
    for (std::size_t i = 10; i < kNoiseLanes; ++i) ends[i] = 0.1 * static_cast<double>(i - 7);
    NoiseLanes normal = ends;
    to_normal(normal);
    for (std::size_t i = 0; i < kNoiseLanes; ++i) CHECK(normal[i] == normal_quantile(ends[i]));
}
