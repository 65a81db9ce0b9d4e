// SPDX-License-Identifier: MIT
#include "polarization/fresnel.hpp"

#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

constexpr double degree = pi / 180;

double dolp(const Stokes& s) {
    return std::hypot(s[1], s[2]) / s[0];
}

}  // namespace

TEST_CASE("dielectric reflection follows the sine and tangent laws") {
    for (const double angle : {5.0, 30.0, 60.0, 85.0}) {
        const double i = angle * degree;
        const double t = std::asin(std::sin(i) / 1.5);
        const double rs = -std::sin(i - t) / std::sin(i + t);
        const double rp = std::tan(i - t) / std::tan(i + t);
        const auto r = fresnel_amplitudes(std::cos(i), RelativeIndex<double>(1.5));
        CHECK(r.s_real == Approx(rs).epsilon(1e-12));
        CHECK(r.p_real == Approx(rp).epsilon(1e-12));
        const Mueller m = fresnel_reflection(std::cos(i), 1.5);
        CHECK(m(0, 0) == Approx((rs * rs + rp * rp) / 2));
        CHECK(m(0, 1) == Approx((rs * rs - rp * rp) / 2));
        CHECK(m(2, 2) == Approx(rs * rp));
        CHECK(m(2, 3) == Approx(0));
    }
}

TEST_CASE("unpolarized light at Brewster's angle comes back fully polarized along the s-axis") {
    const double brewster = std::atan(1.5);
    const Stokes out = fresnel_reflection(std::cos(brewster), 1.5) * Stokes(1, 0, 0, 0);
    CHECK(dolp(out) == Approx(1));
    CHECK(out[1] > 0);  // along x, the s-axis; swapping s and p would change the sign
    // The s2-to-s2 element changes its sign at Brewster's angle.
    CHECK(fresnel_reflection(std::cos(brewster - .1), 1.5)(2, 2) < 0);
    CHECK(fresnel_reflection(std::cos(brewster + .1), 1.5)(2, 2) > 0);
}

TEST_CASE("a mirror at normal incidence changes the handedness of circular light") {
    const Mueller m = fresnel_reflection(1, {0.2, -3.4});
    CHECK(m(3, 3) < 0);
    CHECK(m(2, 2) < 0);
    CHECK(m(1, 1) > 0);
    CHECK(m(3, 3) == Approx(-m(0, 0)));
}

TEST_CASE("a metal makes circular light of linear light at 45 degrees, of the sign that n - ik gives") {
    // The expected value follows the closed form for n - ik: rho = r_p / r_s = |rho| e^{id}.
    const std::complex<double> eta(0.2, -3.4);
    const double c = std::cos(60 * degree);
    const double s2 = 1 - c * c;
    std::complex<double> q = std::sqrt(eta * eta - s2);
    if (q.imag() > 0) q = -q;
    const std::complex<double> rs = (c - q) / (c + q);
    const std::complex<double> rp = (eta * eta * c - q) / (eta * eta * c + q);
    const double d = std::arg(rp) - std::arg(rs);
    const Stokes out = fresnel_reflection(c, eta) * Stokes(1, 0, 1, 0);
    CHECK(out[2] == Approx(std::abs(rs) * std::abs(rp) * std::cos(d)));
    CHECK(out[3] == Approx(std::abs(rs) * std::abs(rp) * std::sin(d)));
    // The conjugate index (n + ik) would describe gain and give the other handedness; ours absorbs.
    const auto r = fresnel_amplitudes(c, RelativeIndex<double>(eta));
    CHECK(std::hypot(r.s_real, r.s_imag) < 1);
    CHECK(std::hypot(r.p_real, r.p_imag) < 1);
}

TEST_CASE("the reflection is that of complex amplitudes for every index, total reflection included") {
    using Complex = std::complex<double>;
    for_all({Complex(1.5), Complex(0.7), Complex(1.0), Complex(1.0003), Complex(0.2, -3.2), Complex(0, -2),
             Complex(2.0, -1e-9)},
            {0.01, 0.3, 0.7, 1.0}, [&](Complex eta, double c) {
                Complex q = std::sqrt(eta * eta - (1 - c * c));
                if (q.imag() > 0) q = std::conj(q);
                const Complex rs = (c - q) / (c + q);
                const Complex rp = (eta * eta * c - q) / (eta * eta * c + q);
                const Complex cross = rp * std::conj(rs);
                const ReflectionBlock<double> block = reflection_block(c, RelativeIndex<double>(eta));
                const double tolerance = 1e-12 * (std::norm(rs) + std::norm(rp)) + 1e-24;
                CHECK(std::abs(block.a - (std::norm(rs) + std::norm(rp)) / 2) <= tolerance);
                CHECK(std::abs(block.b - (std::norm(rs) - std::norm(rp)) / 2) <= tolerance);
                CHECK(std::abs(block.c - cross.real()) <= tolerance);
                CHECK(std::abs(block.d - cross.imag()) <= tolerance);
                const auto single = reflection_block(static_cast<float>(c), RelativeIndex<float>(eta));
                CHECK(std::abs(static_cast<double>(single.a) - block.a) <= 1e-5 * block.a);
                const Mueller m = fresnel_reflection(c, eta);
                CHECK(m(1, 0) == block.b);
                CHECK(m(3, 2) == block.d);
            });
}

TEST_CASE("what is not reflected is transmitted, for each polarization") {
    for_all({1.5, 1 / 1.5}, {0.0, 20.0, 40.0}, [&](double eta, double angle) {
        const Mueller r = fresnel_reflection(std::cos(angle * degree), eta);
        const Mueller t = fresnel_transmission(std::cos(angle * degree), eta);
        CHECK(r(0, 0) + t(0, 0) == Approx(1).epsilon(1e-12));
        CHECK(r(0, 1) + t(0, 1) == Approx(0).epsilon(1e-12));
        // The reverse path through the interface has equal transmittance.
        const double cos_t = std::sqrt(1 - std::pow(std::sin(angle * degree) / eta, 2));
        CHECK(fresnel_transmission(cos_t, 1 / eta)(0, 0) == Approx(t(0, 0)));
        CHECK(fresnel_transmission(cos_t, 1 / eta)(0, 1) == Approx(t(0, 1)));
    });
}

TEST_CASE("total internal reflection keeps all energy and retards") {
    const double eta = 1 / 1.5;
    const double angle = 53.258 * degree;
    const Mueller m = fresnel_reflection(std::cos(angle), eta);
    CHECK(m(0, 0) == Approx(1));
    CHECK(m(0, 1) == Approx(0));
    CHECK(fresnel_transmission(std::cos(angle), eta)(0, 0) == 0);
    // tan(delta / 2) = cos i sqrt(sin^2 i - eta^2) / sin^2 i. delta is the phase between p and s beyond the
    // Verdet sign.
    const double sine = std::sin(angle);
    const double half = std::atan(std::cos(angle) * std::sqrt(sine * sine - eta * eta) / (sine * sine));
    CHECK(std::abs(m(2, 2)) == Approx(std::abs(std::cos(2 * half))));
    CHECK(std::hypot(m(2, 2), m(2, 3)) == Approx(1));
}

TEST_CASE("grazing and normal incidence stay finite") {
    for (const double cosine : {0.0, 1e-300, 1e-9, 1.0}) {
        const Mueller r = fresnel_reflection(cosine, 1.5);
        const Mueller t = fresnel_transmission(cosine, 1.5);
        for (std::size_t i = 0; i < 16; ++i) {
            CHECK(std::isfinite(r(i / 4, i % 4)));
            CHECK(std::isfinite(t(i / 4, i % 4)));
        }
    }
    CHECK(fresnel_reflection(0, 1.5)(0, 0) == Approx(1));
}
