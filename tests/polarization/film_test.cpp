// SPDX-License-Identifier: MIT
#include "polarization/film.hpp"

#include <array>

#include "polarization/fresnel.hpp"
#include "polarization/slab.hpp"
#include "test.hpp"

using namespace nicol;
using doctest::Approx;

namespace {

using Complex = std::complex<double>;

double square(double x) {
    return x * x;
}

double sine2(double cosine) {
    return 1 - cosine * cosine;
}

double difference(const Mueller& a, const Mueller& b) {
    double out = 0;
    for (std::size_t r = 0; r < 4; ++r)
        for (std::size_t c = 0; c < 4; ++c) out = std::max(out, std::abs(a(r, c) - b(r, c)));
    return out;
}

double difference(const SpShares& a, const SpShares& b) {
    return std::max({std::abs(a.s - b.s), std::abs(a.p - b.p), std::abs(a.correlation - b.correlation)});
}

/// Characteristic matrices of thin-film optics (Macleod): reflection and transmission of the tangential
/// electric field of one polarization.
struct Characteristic {
    Complex reflection, transmission;
};
Characteristic by_matrix(double cosine, Complex eta, const ThinFilm& film, double wavelength, bool p) {
    const auto cosine_in = [&](Complex index) {
        Complex c = std::sqrt(1.0 - sine2(cosine) / (index * index));
        if ((index * c).imag() > 0) c = -c;
        return c;
    };
    const auto admittance = [&](Complex index) {
        return p ? index / cosine_in(index) : index * cosine_in(index);
    };
    const Complex delta = 2 * pi * film.thickness / wavelength * film.eta * cosine_in(film.eta);
    const Complex y0 = admittance(1), y1 = admittance(film.eta), y2 = admittance(eta);
    const Complex i(0, 1);
    const Complex b = std::cos(delta) + i * std::sin(delta) / y1 * y2;
    const Complex c = i * y1 * std::sin(delta) + std::cos(delta) * y2;
    return {(y0 * b - c) / (y0 * b + c), 2.0 * y0 / (y0 * b + c)};
}

constexpr std::array<double, 6> kCosines = {1, 0.9, 0.6, 0.35, 0.1, 0.01};

}  // namespace

TEST_CASE("a film without thickness, and one of the medium beside it, is the bare interface") {
    for (const double cosine : kCosines) {
        for (const Complex eta : {Complex(1.5), Complex(0.7), Complex(0.2, -3.4), Complex(2.1, -1.3)}) {
            const Mueller bare = fresnel_reflection(cosine, eta);
            for (const ThinFilm& film : {ThinFilm{0, 1.7}, ThinFilm{0, {1.4, -0.5}}, ThinFilm{300, eta}}) {
                const FilmSplit split = film_split(sine2(cosine), eta, film, 550);
                CHECK(difference(mueller_of(split.front), bare) <= 1e-12);
                if (eta.imag() != 0 || film.thickness != 0) continue;
                CHECK(difference(mueller_of(split.transmission), fresnel_transmission(cosine, eta.real())) <=
                      1e-12);
            }
            // A film of the medium in front only delays light.
            const FilmSplit split = film_split(sine2(cosine), eta, {300, 1}, 550);
            CHECK(difference(mueller_of(split.front), bare) <= 1e-12);
        }
    }
}

TEST_CASE("from behind a film without thickness reflects as the bare interface, also totally") {
    for (const double cosine : {1.0, 0.9, 0.75, 0.7, 0.5, 0.2}) {
        const double tangential2 = 1.5 * 1.5 * sine2(cosine);
        const FilmSplit split = film_split(tangential2, 1.5, {0, 1.7}, 550);
        CHECK(difference(mueller_of(split.back), fresnel_reflection(cosine, 1 / 1.5)) <= 1e-12);
    }
}

TEST_CASE("films reflect and transmit as their characteristic matrices say") {
    for (const double cosine : kCosines) {
        for (const Complex eta : {Complex(1.0), Complex(1.52), Complex(0.2, -3.4), Complex(3.9, -0.02)}) {
            for (const ThinFilm& film :
                 {ThinFilm{120, 1.38}, ThinFilm{431, 2.3}, ThinFilm{90, {1.8, -0.3}}, ThinFilm{700, 1.2}}) {
                const FilmSplit split = film_split(sine2(cosine), eta, film, 500);
                const Characteristic s = by_matrix(cosine, eta, film, 500, false);
                const Characteristic p = by_matrix(cosine, eta, film, 500, true);
                // Tangential electric fields agree at normal incidence, where r_p = -r_s.
                CHECK(difference(split.front, {std::norm(s.reflection), std::norm(p.reflection),
                                               -p.reflection * std::conj(s.reflection)}) <= 1e-11);
                if (eta.imag() != 0) continue;
                const double refracted = std::sqrt(1 - sine2(cosine) / square(eta.real()));
                const double power = eta.real() * refracted / cosine;
                const Complex t_p = p.transmission * cosine / refracted;
                CHECK(difference(split.transmission,
                                 power * SpShares{std::norm(s.transmission), std::norm(t_p),
                                                  t_p * std::conj(s.transmission)}) <= 1e-11);
            }
        }
    }
}

TEST_CASE("a quarter-wave layer of the root of the index reflects nothing, and a half-wave layer is absent") {
    const double eta = 1.9;
    const double root = std::sqrt(eta);
    CHECK(film_split(0, eta, {550 / (4 * root), root}, 550).front.s <= 1e-20);
    CHECK(film_split(0, eta, {550 / (4 * root), root}, 550).front.p <= 1e-20);
    for (const double cosine : kCosines) {
        const double inside = std::sqrt(1.6 * 1.6 - sine2(cosine));
        const FilmSplit half = film_split(sine2(cosine), eta, {550 / (2 * inside), 1.6}, 550);
        CHECK(difference(mueller_of(half.front), fresnel_reflection(cosine, eta)) <= 1e-12);
    }
}

TEST_CASE("a film that absorbs nothing keeps the energy, from both sides, and one that absorbs takes some") {
    for (const double cosine : kCosines) {
        for (const double eta : {1.0, 1.5, 2.4}) {
            const FilmSplit clear = film_split(sine2(cosine), eta, {380, 1.8}, 600);
            CHECK(clear.front.s + clear.transmission.s == Approx(1).epsilon(1e-12));
            CHECK(clear.front.p + clear.transmission.p == Approx(1).epsilon(1e-12));
            CHECK(clear.back.s == Approx(clear.front.s).epsilon(1e-10));
            CHECK(clear.back.p == Approx(clear.front.p).epsilon(1e-10));
            const FilmSplit grey = film_split(sine2(cosine), eta, {380, {1.8, -0.1}}, 600);
            CHECK(grey.front.s + grey.transmission.s < 1);
            CHECK(grey.front.p + grey.transmission.p < 1);
            const FilmSplit opaque = film_split(sine2(cosine), eta, {1e5, {1.8, -0.1}}, 600);
            CHECK(difference(mueller_of(opaque.front), fresnel_reflection(cosine, {1.8, -0.1})) <= 1e-12);
        }
        const FilmSplit total = film_split(1.5 * 1.5 * 0.9, 1.5, {380, 1.8}, 600);
        CHECK(total.back.s == Approx(1).epsilon(1e-12));
        CHECK(std::abs(total.back.correlation) == Approx(1).epsilon(1e-12));
        CHECK(total.transmission.s == 0);
    }
}

TEST_CASE("exchanging the media exchanges the sides of a film") {
    const double eta = 1.6;
    for (const double cosine : kCosines) {
        const FilmSplit one = film_split(sine2(cosine), eta, {250, {2, -0.2}}, 600);
        // The other medium in front: indices and wavelength are relative to that medium.
        const FilmSplit other =
            film_split(sine2(cosine) / (eta * eta), 1 / eta, {250, Complex(2, -0.2) / eta}, 600 / eta);
        CHECK(difference(one.front, other.back) <= 1e-12);
        CHECK(difference(one.back, other.front) <= 1e-12);
        CHECK(difference(one.transmission, other.transmission) <= 1e-12);
    }
}

TEST_CASE("the mean over the phases of a film is the sum of its reflections without interference") {
    constexpr int count = 1000;
    for (const double cosine : {1.0, 0.7, 0.3}) {
        const double inside = std::sqrt(1.5 * 1.5 - sine2(cosine));
        SpShares mean;
        for (int i = 0; i < count; ++i)
            mean +=
                1.0 / count *
                film_split(sine2(cosine), 1, {5000 + (i + 0.5) / count * 550 / (2 * inside), 1.5}, 550).front;
        const SlabSplit slab = slab_split(cosine, 1.5);
        CHECK(difference(mueller_of(mean), slab.reflection) <= 1e-12);
        // A slab whose film is absent is the slab.
        const FilmSplit of = slab_of(film_split(sine2(cosine), 1.5, {0, 1.3}, 550));
        CHECK(difference(mueller_of(of.front), slab.reflection) <= 1e-12);
        CHECK(difference(mueller_of(of.transmission), slab.transmission) <= 1e-12);
    }
}
