// SPDX-License-Identifier: MIT
// Equations that the paper prints wrongly (samples/paper/misprints.md): sums and integrals that use none of
// them agree with the corrected equation and not with the printed one.
#include <complex>

#include "harmonics/evaluate.hpp"
#include "harmonics/reference.hpp"
#include "harmonics/rotation.hpp"
#include "test.hpp"

using namespace nicol;
using Complex = std::complex<double>;

namespace {

constexpr double kExact = 1e-12;
constexpr double kWrong = 1e-3;  // least deviation of a printed equation in these examples

// sY_lm at a direction in the theta-phi frame.
Complex harmonic(int spin, int l, int m, double theta, double phi) {
    return reference::spin_harmonic(spin, l, m, theta) * std::polar(1.0, m * phi);
}

// Integral of conj(2Y_l1m1) Y_l2m2 2Y_l3m3 over the sphere. The azimuth's part is 2 pi if m1 = m2 + m3.
double triple_product(int l1, int m1, int l2, int m2, int l3, int m3) {
    constexpr int rows = 2000;
    double sum = 0;
    for (int j = 0; j < rows; ++j) {
        const double theta = (j + 0.5) * pi / rows;
        sum += std::sin(theta) * reference::spin_harmonic(2, l1, m1, theta) *
               reference::spin_harmonic(0, l2, m2, theta) * reference::spin_harmonic(2, l3, m3, theta);
    }
    return sum * 2 * pi * pi / rows;
}

// Right side of Eq. 216 with the second 3j symbol (l1 l2 l3; a 0 -a).
double by_3j(int l1, int m1, int l2, int m2, int l3, int m3, int a) {
    return (m1 % 2 == 0 ? 1 : -1) * std::sqrt((2 * l1 + 1) * (2 * l2 + 1) * (2 * l3 + 1) / (4 * pi)) *
           reference::wigner_3j(l1, l2, l3, -m1, m2, m3) * reference::wigner_3j(l1, l2, l3, a, 0, -a);
}

}  // namespace

TEST_CASE("M-49: a change of the output's frame is left of the matrix") {
    // s0 of the spin-2 block: (s1, s2) of the output are M (s1, s2) of the input.
    const Complex iso(0.4, -0.3), conjugation(-0.2, 0.7), in(0.5, 0.9);
    const double alpha = 0.3, beta = 1.1;  // rotations of the input's and the output's frame
    const Complex out = iso * in + conjugation * std::conj(in);
    const Complex rotated_in = std::polar(1.0, -2 * alpha) * in,
                  rotated_out = std::polar(1.0, -2 * beta) * out;
    const auto apply = [&](double left, double right) {
        const Complex given = std::polar(1.0, 2 * right) * rotated_in;
        return std::polar(1.0, -2 * left) * (iso * given + conjugation * std::conj(given));
    };
    CHECK(std::abs(apply(beta, alpha) - rotated_out) < kExact);
    CHECK(std::abs(apply(alpha, beta) - rotated_out) > kWrong);
}

TEST_CASE("S-107: harmonics of opposite directions differ by the sign of the order alone") {
    for (int l = 0; l <= 5; ++l) {
        for (int m = -l; m <= l; ++m) {
            const Complex here = harmonic(0, l, m, 0.8, 0.5),
                          opposite = harmonic(0, l, m, pi - 0.8, 0.5 + pi);
            CHECK(std::abs(opposite - (l % 2 == 0 ? 1.0 : -1.0) * here) < kExact);
            if (m % 2 != 0) CHECK(std::abs(opposite + (l % 2 == 0 ? 1.0 : -1.0) * here) > kWrong);
        }
    }
}

TEST_CASE("S-118: D^1 at m = 1, m' = 0 has exp(-i alpha)") {
    const double alpha = 0.7, beta = 1.2;
    PshVector zonal(1, 1);
    zonal.channel(0)[4 * psh_index(1, 0)] = 1;
    const PshVector turned = rotated(zonal, reference::about_z(alpha) * reference::about_y(beta));
    // The complex coefficient of m = 1 from those of the real harmonics sqrt2 Re Y_11 and sqrt2 Im Y_11.
    const Complex of_one(turned.channel(0)[4 * psh_index(1, 1)], -turned.channel(0)[4 * psh_index(1, -1)]);
    const double size = -std::sin(beta) / std::sqrt(2);
    CHECK(std::abs(of_one / std::sqrt(2) - size * std::polar(1.0, -alpha)) < kExact);
    CHECK(std::abs(of_one / std::sqrt(2) - size * std::polar(1.0, alpha)) > kWrong);
}

TEST_CASE("S-214: the mirror image conjugates coefficients") {
    const int l = 3, m = 1;
    const Complex coefficient(0.6, 0.8);
    const double theta = 0.9, phi = 0.4;
    // The image of f at a direction is conj(f) at the mirrored one, in the theta-phi frames of both.
    const Complex image = std::conj(coefficient * harmonic(2, l, m, pi - theta, phi));
    const double sign = l % 2 == 0 ? 1 : -1;
    CHECK(std::abs(sign * std::conj(coefficient) * harmonic(2, l, -m, theta, phi) - image) < kExact);
    CHECK(std::abs(sign * coefficient * harmonic(2, l, -m, theta, phi) - image) > kWrong);
}

TEST_CASE("S-216: the second 3j symbol of the triple product is (l1 l2 l3; 2 0 -2)") {
    const double even = triple_product(3, 1, 2, 0, 3, 1), odd = triple_product(3, 1, 1, 0, 3, 1);
    REQUIRE(std::abs(odd) > kWrong);
    CHECK(by_3j(3, 1, 2, 0, 3, 1, 2) == doctest::Approx(even).epsilon(1e-5));
    CHECK(by_3j(3, 1, 2, 0, 3, 1, -2) == doctest::Approx(even).epsilon(1e-5));
    CHECK(by_3j(3, 1, 1, 0, 3, 1, 2) == doctest::Approx(odd).epsilon(1e-5));
    CHECK(std::abs(by_3j(3, 1, 1, 0, 3, 1, -2) - odd) > kWrong);
}

TEST_CASE("M-69a, S-203, S-230: s0 gains the product of the light with a conjugate") {
    const double k01 = 0.3, k02 = -0.5;  // row of s0 in a Mueller matrix
    const Complex light(0.7, 0.2);
    const Complex held(k01, k02);  // as S-203 defines it
    const double gained = k01 * light.real() + k02 * light.imag();
    CHECK(std::real(std::conj(held) * light) == doctest::Approx(gained));
    CHECK(std::abs(std::real(held * light) - gained) > kWrong);
}
