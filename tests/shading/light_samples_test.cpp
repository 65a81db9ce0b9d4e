// SPDX-License-Identifier: MIT
#include "shading/light_samples.hpp"

#include <bit>
#include <cmath>
#include <set>

#include "test.hpp"

using namespace nicol;

TEST_CASE("Shuffling permutes the samples") {
    for (const std::uint32_t count : {1U, 2U, 3U, 16U, 100U, 1024U}) {
        CAPTURE(count);
        std::set<std::uint32_t> found;
        for (std::uint32_t k = 0; k < std::bit_ceil(count); ++k) found.insert(shuffled_sample(k, count));
        CHECK(found.size() == std::bit_ceil(count));
        CHECK(*found.rbegin() == std::bit_ceil(count) - 1);
    }
}

TEST_CASE("A shuffled sample does not depend on the sample beside it") {
    constexpr std::uint32_t count = 256;
    constexpr std::uint32_t seeds = 64;
    // Covariances of the first numbers, and of the second, over the samples of a seed; at most 1 / 12.
    double of_first = 0;
    double of_second = 0;
    for (std::uint32_t seed = 0; seed < seeds; ++seed) {
        double first = 0;
        double second = 0;
        const std::uint32_t one[] = {sample_seed(seed, 1)};
        const std::uint32_t other[] = {sample_seed(seed, 2)};
        for (std::uint32_t k = 0; k < count; ++k) {
            Lanes u, v, p, q;
            light_samples(k, one, u, v);
            light_samples(shuffled_sample(k, count), other, p, q);
            first += double{u[0] - 0.5F} * double{p[0] - 0.5F} / count;
            second += double{v[0] - 0.5F} * double{q[0] - 0.5F} / count;
        }
        of_first += first * first / seeds;
        of_second += second * second / seeds;
    }
    CHECK(std::sqrt(of_first) < 0.015);
    CHECK(std::sqrt(of_second) < 0.015);
}
