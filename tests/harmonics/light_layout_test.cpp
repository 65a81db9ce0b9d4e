// SPDX-License-Identifier: MIT
#include "harmonics/light_layout.hpp"

#include "harmonics/light_coefficients.hpp"
#include "harmonics/rotation.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

PshVector random_light(int order, LightKind kind) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    PshVector out(order, 1);
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            for (int p = 0; p < static_cast<int>(kind); ++p)
                if (l >= 2 || p == 0 || p == 3) out.at(0, l, m, p) = normal(random);
    return out;
}

}  // namespace

TEST_CASE("the numbers of a light are its coefficients over another orthonormal basis") {
    for_all({LightKind::unpolarized, LightKind::linear, LightKind::full}, {0, 1, 2, 3, 6},
            [&](LightKind kind, int order) {
                const LightLayout layout(order, kind);
                const PshVector light = random_light(order, kind);
                const std::vector<double> numbers = test::light_coefficients(layout, light.channel(0));
                CHECK(numbers.size() == layout.size());
                std::vector<double> back(light.channel(0).size());
                for (std::size_t j = 0; j < numbers.size(); ++j)
                    for (const LightLayout::Term& term : layout.terms()[j])
                        back[term.coefficient] += term.factor * numbers[j];
                CHECK(largest_difference(back, light.channel(0)) < 1e-14);
            });
    CHECK_THROWS_AS(LightLayout(-1, LightKind::full), Error);
    CHECK_THROWS_AS(LightLayout(kMaxOrder + 1, LightKind::full), Error);
}

TEST_CASE("every number is in one pair, and a viewer's azimuth rotates pairs") {
    constexpr int order = 5;
    constexpr double azimuth = 0.7;
    const glm::dmat3 about_z(std::cos(azimuth), -std::sin(azimuth), 0, std::sin(azimuth), std::cos(azimuth),
                             0, 0, 0, 1);
    for (const LightKind kind : {LightKind::unpolarized, LightKind::linear, LightKind::full}) {
        const LightLayout layout(order, kind);
        std::vector<int> uses(layout.size());
        for (const LightLayout::Run& run : layout.runs()) {
            for (std::size_t i = 0; i < run.count; ++i) {
                ++uses[run.even + i];
                if (run.odd != run.even) ++uses[run.odd + i];
            }
        }
        CHECK(uses == std::vector<int>(layout.size(), 1));
        const PshVector light = random_light(order, kind);
        const auto before = test::light_pairs(layout, light.channel(0));
        const auto after = test::light_pairs(layout, rotated(light, about_z).channel(0));
        CHECK(before.size() == layout.row_size());
        double error = 0;
        std::size_t j = 0;
        for (const LightLayout::Run& run : layout.runs()) {
            const auto phase = std::polar(1.0, -static_cast<double>(run.sign) * run.m * azimuth);
            for (std::size_t i = 0; i < run.count; ++i, ++j)
                error = std::max(error, std::abs(after[j] - phase * before[j]));
        }
        CHECK(error < 1e-12);
    }
}
