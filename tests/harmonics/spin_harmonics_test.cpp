// SPDX-License-Identifier: MIT
// Tests of spin harmonics against explicit sums in high precision, near and at both poles.
#include "harmonics/spin_harmonics.hpp"

#include "harmonics/grid.hpp"
#include "harmonics/reference.hpp"
#include "test.hpp"

using namespace nicol;

namespace {

constexpr double kEps = std::numeric_limits<double>::epsilon();

double norm(int l) {
    return std::sqrt((2 * l + 1) / (4 * pi));
}

/// Returns the degrees to compare: the edges, those near the spin, and some in between.
std::vector<int> degrees(int l) {
    std::vector<int> out;
    for (const int m : {0, 1, 2, 3, 4, l / 3, 2 * l / 3, l - 2, l - 1, l}) {
        if (m < 0 || m > l || (!out.empty() && out.back() >= m)) continue;
        out.push_back(m);
    }
    for (std::size_t i = out.size(); i-- > 0;)
        if (out[i] > 0) out.push_back(-out[i]);
    return out;
}

double worst_in_units_of_l_eps(int spin, const std::vector<int>& orders, const std::vector<double>& thetas) {
    double worst = 0;
    for (const double theta : thetas) {
        std::vector<double> y(psh_count(orders.back()));
        spin_harmonics(spin, orders.back(), theta, y);
        for (const int l : orders)
            for (const int m : degrees(l)) {
                const double have = y[psh_index(l, m)];
                const double want = reference::spin_harmonic(spin, l, m, theta);
                const double error = std::abs(have - want) / (std::max(l, 1) * kEps * norm(l));
                worst = std::isfinite(have) ? std::max(worst, error) : INFINITY;
            }
    }
    return worst;
}

const std::vector<double> kThetas = {0, 1e-300, 1e-12, 1e-6, 1e-3, .7, pi / 2, 2.5, pi - 1e-6, pi};

}  // namespace

TEST_CASE("spin harmonics are right to 5 l eps, every spin, to order 1000") {
    for (int spin = -kMaxSpin; spin <= kMaxSpin; ++spin) {
        CAPTURE(spin);
        CHECK(worst_in_units_of_l_eps(spin, {0, 1, 2, 3, 4, 5, 9, 32, 100}, kThetas) <= 5);
    }
    for (const int spin : {0, 2}) CHECK(worst_in_units_of_l_eps(spin, {300, 1000}, kThetas) <= 5);
    CHECK(worst_in_units_of_l_eps(-2, {1000}, {1e-3, .7, 2.5, pi}) <= 5);
}

TEST_CASE("the poles are exact") {
    for (const int order : {2, 9, 300}) {
        std::vector<double> north(psh_count(order));
        std::vector<double> south(psh_count(order));
        spin_harmonics(2, order, 0, 1, north);
        spin_harmonics(2, order, 1, 0, south);
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m) {
                CHECK(north[psh_index(l, m)] ==
                      doctest::Approx(l >= 2 && m == -2 ? norm(l) : 0).epsilon(1e-15 * order));
                CHECK(south[psh_index(l, m)] ==
                      doctest::Approx(l >= 2 && m == 2 ? (l % 2 == 0 ? 1 : -1) * norm(l) : 0)
                          .epsilon(1e-15 * order));
            }
    }
}

TEST_CASE("no value is lost up to order 4096") {
    std::vector<double> y(psh_count(kMaxOrder));
    for_all({1e-3, .3, .4, pi}, {0, 2}, [&](double theta, int spin) {
        spin_harmonics(spin, kMaxOrder, theta, y);
        // The sum over m of |sY_lm|^2 is (2l+1)/4pi everywhere, so a missing significant value is detected.
        for (const int l : {2, 1075, 2048, 4096}) {
            double sum = 0;
            for (int m = -l; m <= l; ++m) sum += y[psh_index(l, m)] * y[psh_index(l, m)];
            CHECK(sum / ((2 * l + 1) / (4 * pi)) == doctest::Approx(1).epsilon(1e-11));
        }
    });
    spin_harmonics(2, kMaxOrder, .4, y);
    for (const int m : {-1500, -2, 900, 1594})
        CHECK(y[psh_index(4096, m)] ==
              doctest::Approx(reference::spin_harmonic(2, 4096, m, .4)).epsilon(0).scale(1).epsilon(1e-11));
}
TEST_CASE("known values fix the signs") {
    std::vector<double> y(psh_count(2));
    spin_harmonics(0, 2, .8, y);
    CHECK(y[psh_index(1, 1)] == doctest::Approx(-std::sqrt(3 / (8 * pi)) * std::sin(.8)));
    CHECK(y[psh_index(1, -1)] == doctest::Approx(std::sqrt(3 / (8 * pi)) * std::sin(.8)));
    spin_harmonics(2, 2, .8, y);
    const double h = std::cos(.4);
    CHECK(y[psh_index(2, -2)] == doctest::Approx(std::sqrt(5 / (4 * pi)) * h * h * h * h));
    CHECK(y[psh_index(2, 0)] == doctest::Approx(std::sqrt(15 / (32 * pi)) * std::sin(.8) * std::sin(.8)));
}

TEST_CASE("real and complex coefficients convert back and forth, and mean the same field") {
    std::mt19937_64 random(7);
    std::normal_distribution<double> normal;
    const int order = 6;
    std::vector<std::complex<double>> real(psh_count(order));
    for (auto& value : real) value = normal(random);
    std::vector<std::complex<double>> complex(real.size());
    std::vector<std::complex<double>> back(real.size());
    complex_from_real(real, complex);
    real_from_complex(complex, back);
    std::vector<double> y(real.size());
    spin_harmonics(0, order, 1.3, y);
    std::complex<double> sum_complex = 0;
    double sum_real = 0;
    const double phi = .6;
    for (int l = 0; l <= order; ++l)
        for (int m = -l; m <= l; ++m) {
            const std::size_t i = psh_index(l, m);
            CHECK(std::abs(back[i] - real[i]) < 1e-14);
            sum_complex += complex[i] * y[i] * std::polar(1.0, m * phi);
            const double positive = y[psh_index(l, std::abs(m))];
            sum_real += real[i].real() * (m > 0   ? std::sqrt(2.) * positive * std::cos(m * phi)
                                          : m < 0 ? std::sqrt(2.) * positive * std::sin(-m * phi)
                                                  : positive);
        }
    CHECK(std::abs(sum_complex - sum_real) < 1e-13);
}

TEST_CASE("spin harmonics refuse bad arguments") {
    std::vector<double> y(psh_count(3));
    for (const auto& [spin, order, theta] : {std::tuple(5, 3, .1),
                                             {2, 4, .1},
                                             {2, -1, .1},
                                             {2, kMaxOrder + 1, .1},
                                             {2, 3, -.1},
                                             {2, 3, 3.2},
                                             {2, 3, std::nan("")}})
        CHECK_THROWS_AS(spin_harmonics(spin, order, theta, y), Error);
    CHECK_THROWS_AS(spin_harmonics(2, 3, .5, .5, y), Error);
    CHECK_THROWS_AS(spin_harmonics(2, 3, std::nan(""), 1, y), Error);
    std::vector<std::complex<double>> five(5);
    CHECK_THROWS_AS(real_from_complex(five, five), Error);
}
