// SPDX-License-Identifier: MIT
// Tests of folded sums of few degrees against their definition.
#include "light/folded_sums.hpp"

#include "test.hpp"

using namespace nicol;

TEST_CASE("folded sums are the sums of their definition") {
    std::mt19937 engine(3);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for_all({16, 20, 64, 260, 1000}, {0, 1, 2, 5, 12, 40}, [&](int columns, int order) {
        REQUIRE(FoldedSums::suits(order, columns));
        const auto width = static_cast<std::size_t>(columns);
        std::vector<float> values(4 * width);
        for (float& v : values) v = uniform(engine);
        FoldedSums fold(order, columns);
        for (const std::size_t stride : {std::size_t{1}, std::size_t{4}}) {
            FourRows rows{{}, stride};
            for (std::size_t k = 0; k < 4; ++k) rows.first[k] = values.data() + k * (stride == 1 ? width : 1);
            const std::span<const double> sums = fold(rows);
            REQUIRE(sums.size() == 8 * (static_cast<std::size_t>(order) + 1));
            double largest = 0;
            for (int m = 0; m <= order; ++m) {
                for (std::size_t k = 0; k < 4; ++k) {
                    double cosine = 0;
                    double sine = 0;
                    for (std::size_t c = 0; c < width; ++c) {
                        const double angle = 2 * pi * m * (static_cast<double>(c) + 0.5) / columns;
                        cosine += rows.first[k][c * stride] * std::cos(angle);
                        sine += rows.first[k][c * stride] * std::sin(angle);
                    }
                    const std::size_t at = 8 * static_cast<std::size_t>(m) + k;
                    largest = std::max({largest, std::abs(sums[at] - cosine), std::abs(sums[at + 4] - sine)});
                }
            }
            CHECK(largest < 1e-14 * columns * (order + 1));
        }
    });
    for (const int columns : {18, 31, 12}) CHECK_FALSE(FoldedSums::suits(2, columns));
}
