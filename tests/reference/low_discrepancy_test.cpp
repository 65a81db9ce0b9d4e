// SPDX-License-Identifier: MIT
#include <set>

#include "reference/low_discrepancy.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("every aligned run of 2^k points has one in each dyadic box of area 2^-k") {
    for (const std::uint64_t seed : {0ULL, 1ULL, 0x123456789ABCDEFULL}) {
        const LowDiscrepancy points(seed);
        for_all({0U, 1U, 2U}, {1, 4, 6, 9}, [&](std::uint32_t stream, int k) {
            const std::uint32_t count = 1U << k;
            for (const std::uint32_t first : {0U, count, 5 * count}) {
                for (int a = 0; a <= k; ++a) {
                    std::set<std::pair<int, int>> boxes;
                    for (std::uint32_t i = first; i < first + count; ++i) {
                        const glm::dvec2 p = points.point(i, stream);
                        REQUIRE(p.x >= 0);
                        REQUIRE(p.x < 1);
                        REQUIRE(p.y >= 0);
                        REQUIRE(p.y < 1);
                        boxes.emplace(static_cast<int>(std::ldexp(p.x, a)),
                                      static_cast<int>(std::ldexp(p.y, k - a)));
                    }
                    CHECK(boxes.size() == count);
                }
            }
        });
    }
}

TEST_CASE("streams, seeds and neighbouring pixels do not correlate") {
    constexpr int count = 4096;
    const auto correlation = [](const auto& first, const auto& second) {
        double product = 0;
        for (int i = 0; i < count; ++i) {
            const auto index = static_cast<std::uint32_t>(i);
            product += (first(index) - 0.5) * (second(index) - 0.5);
        }
        return 12 * product / count;  // the variance is 1 / 12
    };
    const LowDiscrepancy a(7), b(8);
    for (std::uint32_t s = 0; s < 3; ++s) {
        for (std::uint32_t t = 0; t < 3; ++t) {
            const auto x = [&](std::uint32_t i) { return a.point(i, s).x; };
            const auto y = [&](std::uint32_t i) { return a.point(i, t).y; };
            const auto other_x = [&](std::uint32_t i) { return a.point(i, t).x; };
            const auto other_seed = [&](std::uint32_t i) { return b.point(i, t).x; };
            CHECK(std::abs(correlation(x, y)) < 0.06);
            if (s != t) CHECK(std::abs(correlation(x, other_x)) < 0.06);
            CHECK(std::abs(correlation(x, other_seed)) < 0.06);
        }
    }
}

TEST_CASE("one point over many seeds is evenly distributed, down to its last digits") {
    constexpr int count = 20000, bins = 16;
    for (const std::uint32_t index : {0U, 1U, 6U, 255U}) {
        std::vector<double> bits(48), histogram_x(bins), histogram_y(bins);
        for (int i = 0; i < count; ++i) {
            const glm::dvec2 p = LowDiscrepancy(mixed(3, static_cast<std::uint64_t>(i))).point(index, 1);
            ++histogram_x[static_cast<std::size_t>(p.x * bins)];
            ++histogram_y[static_cast<std::size_t>(p.y * bins)];
            for (std::size_t bit = 0; bit < bits.size(); ++bit)
                bits[bit] += std::fmod(std::floor(std::ldexp(p.x, static_cast<int>(bit) + 1)), 2.0);
        }
        for (const auto& histogram : {histogram_x, histogram_y}) {
            for (const double n : histogram)
                CHECK(std::abs(n - count / bins) < 5 * std::sqrt(1.0 * count / bins));
        }
        for (const double ones : bits) CHECK(std::abs(ones / count - 0.5) < 0.02);
    }
}
