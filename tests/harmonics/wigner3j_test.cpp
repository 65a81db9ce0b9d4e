// SPDX-License-Identifier: MIT
// Tests of 3j symbols against Racah's sum.
#include "harmonics/wigner3j.hpp"

#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

TEST_CASE("every small symbol agrees with Racah's sum") {
    double worst = 0;
    for (int l2 = 0; l2 <= 5; ++l2)
        for (int l3 = 0; l3 <= 5; ++l3)
            for (int m2 = -l2; m2 <= l2; ++m2)
                for (int m3 = -l3; m3 <= l3; ++m3) {
                    const Wigner3jRun run = wigner_3j_run(l2, l3, m2, m3);
                    for (int l1 = 0; l1 <= 11; ++l1)
                        worst = std::max(
                            worst, std::abs(run.at(l1) - reference::wigner_3j(l1, l2, l3, -m2 - m3, m2, m3)));
                }
    CHECK(worst < 1e-15);
}

TEST_CASE("large symbols keep their relative accuracy, also where they are tiny") {
    for (const auto& [l2, l3, m2, m3] :
         {std::array{40, 60, 3, -5}, std::array{100, 100, 0, 0}, std::array{100, 100, 90, 95},
          std::array{120, 30, -100, 2}, std::array{200, 200, 150, -150}, std::array{200, 1, 10, 1},
          std::array{150, 150, 1, -2}, std::array{64, 64, 2, -2}}) {
        const Wigner3jRun run = wigner_3j_run(l2, l3, m2, m3);
        double largest = 0;
        for (const double value : run.value) largest = std::max(largest, std::abs(value));
        for (int l1 = run.first_l1; l1 <= std::min(l2 + l3, 300); l1 += 7) {
            const double want = reference::wigner_3j(l1, l2, l3, -m2 - m3, m2, m3);
            CAPTURES(l1, l2, m2);
            CHECK(std::abs(run.at(l1) - want) < 1e-12 * std::max(std::abs(want), .05 * largest));
        }
        // The ends lie far below the largest value, so they are compared relatively.
        CHECK(run.at(run.first_l1) ==
              doctest::Approx(reference::wigner_3j(run.first_l1, l2, l3, -m2 - m3, m2, m3)).epsilon(1e-10));
        CHECK(run.at(l2 + l3) ==
              doctest::Approx(reference::wigner_3j(l2 + l3, l2, l3, -m2 - m3, m2, m3)).epsilon(1e-10));
    }
}

TEST_CASE(
    "symbols of order a thousand are finite and normalised; alternating sums that need log-gamma are not "
    "used") {
    for (const auto& [l2, l3, m2, m3] : {std::array{1000, 1000, 2, -2}, std::array{4000, 4000, 1500, -1500},
                                         std::array{4096, 4096, 4096, 4096}, std::array{3000, 900, 3, 890}}) {
        const Wigner3jRun run = wigner_3j_run(l2, l3, m2, m3);
        double sum = 0;
        for (std::size_t i = 0; i < run.value.size(); ++i)
            sum += (2.0 * (run.first_l1 + static_cast<int>(i)) + 1) * run.value[i] * run.value[i];
        CHECK(sum == doctest::Approx(1).epsilon(1e-11));
    }
    // Runs with different degrees of equal sum are orthogonal.
    const Wigner3jRun a = wigner_3j_run(500, 400, 20, -7);
    const Wigner3jRun b = wigner_3j_run(500, 400, 300, -287);
    double dot = 0;
    for (int l1 = 100; l1 <= 900; ++l1) dot += (2 * l1 + 1) * a.at(l1) * b.at(l1);
    CHECK(std::abs(dot) < 1e-11);
}

TEST_CASE("runs refuse bad arguments") {
    CHECK_THROWS_AS(wigner_3j_run(2, 2, 3, 0), Error);
    CHECK_THROWS_AS(wigner_3j_run(5000, 2, 3, 0), Error);
}
