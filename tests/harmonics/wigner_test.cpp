// SPDX-License-Identifier: MIT
// Tests of Wigner matrices against explicit sums, and as a representation of the rotation group.
#include "harmonics/wigner.hpp"

#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

double entry(const std::vector<double>& d, int l, int m, int n) {
    return d[wigner_offset(l) + static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)];
}

// Returns d^l alone, also above kMaxWignerOrder, by row m + l and column n + l.
std::vector<double> single_block(int l, double beta) {
    WignerSweep sweep(l, {std::sin(beta / 2), std::cos(beta / 2)});
    while (sweep.l() < l) sweep.step();
    std::vector<double> d(static_cast<std::size_t>((2 * l + 1) * (2 * l + 1)));
    sweep.block(d.data());
    return d;
}

}  // namespace

TEST_CASE("d agrees with Wigner's sum at every angle") {
    for (const double beta : {0.0, 1e-300, 1e-9, 1e-3, .7, pi / 2, 2.5, pi - 1e-6, pi}) {
        const int order = 60;
        const auto d = wigner_d(order, beta);
        CHECK(d.size() == wigner_offset(order + 1));
        for (const int l : {0, 1, 2, 3, 7, 20, 60})
            for (int m = -l; m <= l; m += 1 + l / 7)
                for (int n = -l; n <= l; n += 1 + l / 5) {
                    CAPTURES(l, m, n, beta);
                    CHECK(std::abs(entry(d, l, m, n) - reference::wigner_d(l, m, n, beta)) <=
                          4e-16 * (1 + l));
                }
    }
}

TEST_CASE("d is orthogonal up to the highest order, from tiny angles to 180 degrees") {
    for (const double beta : {1e-9, .01, .3, pi / 2, 3.1}) {
        const int order = kMaxWignerOrder;
        const auto d = wigner_d(order, beta);
        for (const int l : {1, 10, 100, 256})
            for (int m = -l; m <= l; m += 1 + l / 4)
                for (int k = -l; k <= l; k += 1 + l / 6) {
                    double dot = 0;
                    for (int n = -l; n <= l; ++n) dot += entry(d, l, m, n) * entry(d, l, k, n);
                    CHECK(std::abs(dot - (m == k)) < 1e-15 * (10 + 4 * l));
                }
    }
}

TEST_CASE("angles add up, negative ones and those beyond 360 degrees too") {
    const int order = 12;
    const auto a = wigner_d(order, -2.2);
    const auto b = wigner_d(order, 5.9);
    const auto sum = wigner_d(order, 3.7);
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m)
            for (int n = -l; n <= l; ++n) {
                double dot = 0;
                for (int k = -l; k <= l; ++k) dot += entry(a, l, m, k) * entry(b, l, k, n);
                CHECK(dot == doctest::Approx(entry(sum, l, m, n)).epsilon(0).scale(1).epsilon(1e-14));
            }
}

TEST_CASE("entries that start below the range of double grow back") {
    const int l = 1350;
    const double beta = .7;
    const auto d = single_block(l, beta);
    double largest = 0;
    for (const auto& [m, n] : {std::pair(450, -450), std::pair(-450, 450), std::pair(470, -430),
                               std::pair(0, 0), std::pair(3, -2), std::pair(1350, 1348)}) {
        const double want = reference::wigner_d(l, m, n, beta);
        const double have = d[static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)];
        CAPTURES(m, n);
        CHECK(std::abs(have - want) < 1e-12);
        if (m - n == 900) largest = std::max(largest, std::abs(want));
    }
    CHECK(largest > .01);  // grown from a first value of 2^-1390
}

TEST_CASE("rows that pass from far below the range of double to one keep their length") {
    const int l = 1150;
    const auto d = single_block(l, pi / 2);
    const auto at = [&](int m, int n) { return d[static_cast<std::size_t>((m + l) * (2 * l + 1) + n + l)]; };
    for (const int m : {-1150, -1130, 0, 560, 810, 1130, 1150}) {
        double square = 0;
        for (int n = -l; n <= l; ++n) square += at(m, n) * at(m, n);
        CHECK(square == doctest::Approx(1).epsilon(1e-11));
    }
    CHECK(std::abs(at(1140, 30) - reference::wigner_d(l, 1140, 30, pi / 2)) < 1e-12);
}

TEST_CASE("Wigner matrices refuse bad arguments") {
    CHECK_THROWS_AS(wigner_d(-1, .1), Error);
    CHECK_THROWS_AS(wigner_d(kMaxWignerOrder + 1, .1), Error);
    CHECK_THROWS_AS(wigner_d(2, INFINITY), Error);
}
