// SPDX-License-Identifier: MIT
#include "polarization/film.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace nicol {
namespace {

using Complex = std::complex<double>;

// Least normal part of a wave vector, because the amplitudes of waves along the interface are 0 / 0.
constexpr double kGrazing = 1e-7;

// Returns n cos(theta) in a medium, with the sign of a wave that decays for indices n - ik.
Complex normal_part(Complex index2, double tangential2) {
    const Complex root = std::sqrt(index2 - tangential2);
    return root.imag() > 0 ? -root : root;
}

// Amplitudes of one polarization. Reflection is that of the tangential field in an interface whose media have
// the admittances a and b: of the electric field for s, and of the magnetic field for p.
struct Amplitudes {
    Complex front, back, transmission;
};

Amplitudes airy(Complex front, Complex film, Complex behind, Complex phase) {
    const Complex r01 = (front - film) / (front + film);
    const Complex r12 = (film - behind) / (film + behind);
    const Complex scale = 1.0 / (1.0 + r01 * r12 * phase * phase);
    return {(r01 + r12 * phase * phase) * scale, -(r12 + r01 * phase * phase) * scale,
            (1.0 + r01) * (1.0 + r12) * phase * scale};
}

SpShares shares_of(Complex s, Complex p, double scale_s, double scale_p) {
    return {scale_s * std::norm(s), scale_p * std::norm(p), std::sqrt(scale_s * scale_p) * p * std::conj(s)};
}

// 1 / (1 - x^2) for each part.
SpShares even_reflections(const SpShares& x) {
    return {1 / (1 - x.s * x.s), 1 / (1 - x.p * x.p), 1.0 / (1.0 - x.correlation * x.correlation)};
}

}  // namespace

SpShares& SpShares::operator+=(const SpShares& other) {
    s += other.s;
    p += other.p;
    correlation += other.correlation;
    return *this;
}

SpShares operator+(SpShares a, const SpShares& b) {
    return a += b;
}

ReflectionBlock<double> block_of(const SpShares& shares) {
    return {(shares.s + shares.p) / 2, (shares.s - shares.p) / 2, shares.correlation.real(),
            shares.correlation.imag()};
}

FilmSplit film_split(double tangential2, Complex eta, const ThinFilm& film, double wavelength) {
    const bool total = tangential2 > 1;
    const Complex front = total ? Complex(0, -std::sqrt(tangential2 - 1))
                                : Complex(std::max(kGrazing, std::sqrt(1 - tangential2)));
    const Complex film2 = film.eta * film.eta;
    const Complex eta2 = eta * eta;
    Complex inside = normal_part(film2, tangential2);
    if (std::abs(inside) < kGrazing) inside = kGrazing;
    Complex behind = normal_part(eta2, tangential2);
    if (std::abs(behind) < kGrazing) behind = kGrazing;
    const Complex phase = std::exp(Complex(0, -2 * std::numbers::pi * film.thickness / wavelength) * inside);
    const Amplitudes s = airy(front, inside, behind, phase);
    const Amplitudes p = airy(front, inside / film2, behind / eta2, phase);

    FilmSplit out{.front = shares_of(s.front, p.front, 1, 1),
                  .back = shares_of(s.back, p.back, 1, 1),
                  .transmission = {}};
    const bool propagates = !total && behind.real() > 0 && behind.imag() == 0;
    if (propagates)
        out.transmission = shares_of(s.transmission, p.transmission, (behind / front).real(),
                                     (behind / (eta2 * front)).real());
    return out;
}

FilmSplit slab_of(const FilmSplit& side) {
    // No light enters a slab under total reflection.
    if (!(side.transmission.s + side.transmission.p > 0))
        return {.front = side.front, .back = side.front, .transmission = {}};
    // t (1 + r^2 + ...) t passes, and r0 + t (r + r^3 + ...) t returns.
    const SpShares passes = side.transmission * side.transmission * even_reflections(side.back);
    const SpShares reflection = side.front + side.back * passes;
    return {.front = reflection, .back = reflection, .transmission = passes};
}

}  // namespace nicol
