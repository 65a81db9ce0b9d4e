// SPDX-License-Identifier: MIT
// Reflection and refraction at a smooth interface, written once for single numbers and for vectors of lanes.
#pragma once

#include <complex>

#include "polarization/mueller.hpp"
#include "polarization/view_geometry.hpp"
#include "simd/number.hpp"

namespace nicol {

/// The relative index n - ik of the far side, as the formulas below need it. Real: float or double.
template <class Real>
struct RelativeIndex {
    explicit RelativeIndex(std::complex<double> eta)
        : real_square(static_cast<Real>((eta * eta).real())),
          imaginary_square(static_cast<Real>((eta * eta).imag())),
          excess(static_cast<Real>((eta * eta).real() - 1)) {}

    Real real_square;       ///< real part of eta^2
    Real imaginary_square;  ///< imaginary part of eta^2
    Real excess;            ///< real_square - 1, without cancellation
};

/// Amplitude coefficients of the parts perpendicular (s) and parallel (p) to the plane of incidence, in the
/// Verdet sign convention (at normal incidence p = -s).
template <class Number>
struct FresnelAmplitudes {
    Number s_real, s_imag;
    Number p_real, p_imag;
};

/// Fresnel's reflection [[a, b, 0, 0], [b, a, 0, 0], [0, 0, c, -d], [0, 0, d, c]]. Both frames have x along
/// the s-axis and z along the propagation.
template <class Number>
struct ReflectionBlock {
    Number a, b, c, d;
};

[[nodiscard]] inline Mueller mueller_of(const ReflectionBlock<double>& block) {
    const auto [a, b, c, d] = block;
    return Mueller({a, b, 0, 0, b, a, 0, 0, 0, 0, c, -d, 0, 0, d, c});
}

/// Amplitudes for cosines of 0 to 1 and any index. Total internal reflection gives coefficients of modulus
/// one.
template <class Number>
[[gnu::always_inline]] inline FresnelAmplitudes<Number> fresnel_amplitudes(
    const Number& cosine, const RelativeIndex<ScalarOf<Number>>& index) {
    // q = eta cos_t, the square root of x + iy, y <= 0, whose imaginary part is negative: with indices n - ik
    // that is a decaying wave.
    const Number x = index.excess + cosine * cosine;
    const ScalarOf<Number> y = index.imaginary_square;
    Number q2 = x * x + y * y;
    square_root(q2);
    Number large = 0.5F * (q2 + (x > 0.0F ? x : -x));
    square_root(large);
    constexpr ScalarOf<Number> least = constant<Number>(1e-18);
    large = large > least ? large : Number{} + least;
    const Number small = 0.5F * y / large;
    const Number q_real = x > 0.0F ? large : -small;
    const Number q_imag = x > 0.0F ? small : -large;

    // (cos - q) / (cos + q) and (eta^2 cos - q) / (eta^2 cos + q).
    const Number s_sum = cosine + q_real;
    const Number s_scale = 1.0F / (s_sum * s_sum + q_imag * q_imag);
    const Number e_real = index.real_square * cosine;
    const Number e_imag = index.imaginary_square * cosine;
    const Number p_sum = e_real + q_real;
    const Number p_sum_imag = e_imag + q_imag;
    const Number p_scale = 1.0F / (p_sum * p_sum + p_sum_imag * p_sum_imag);
    return {(cosine * cosine - q2) * s_scale, -2.0F * cosine * q_imag * s_scale,
            (e_real * e_real + e_imag * e_imag - q2) * p_scale,
            2.0F * (e_imag * q_real - e_real * q_imag) * p_scale};
}

/// |r_s r_p| e^{id} with d = arg r_p - arg r_s is a product of the amplitudes, which carries the sign change
/// at Brewster's angle by itself.
template <class Number>
[[gnu::always_inline]] inline ReflectionBlock<Number> block_of(const FresnelAmplitudes<Number>& r) {
    const Number s2 = r.s_real * r.s_real + r.s_imag * r.s_imag;
    const Number p2 = r.p_real * r.p_real + r.p_imag * r.p_imag;
    return {0.5F * (s2 + p2), 0.5F * (s2 - p2), r.p_real * r.s_real + r.p_imag * r.s_imag,
            r.p_imag * r.s_real - r.p_real * r.s_imag};
}

/// reflection_block() of a real index.
template <class Number>
[[gnu::always_inline]] inline ReflectionBlock<Number> dielectric_reflection(
    const Number& cosine, const RelativeIndex<ScalarOf<Number>>& index) {
    const Number q2 = index.excess + cosine * cosine;
    Number q = q2 > 0.0F ? q2 : Number{};
    square_root(q);
    // Differences of amplitudes by hand, which keeps the digits where the index is near 1.
    const Number s_sum = cosine + q;
    const Number p_sum = index.real_square * cosine + q;
    const Number s = -index.excess / (s_sum * s_sum);
    const Number p = index.excess * ((index.real_square + 1.0F) * cosine * cosine - 1.0F) / (p_sum * p_sum);
    ReflectionBlock<Number> out = block_of<Number>({s, Number{}, p, Number{}});
    const auto refracted = q2 > 0.0F;
    if (index.excess < 0 && !known(refracted)) {
        const ReflectionBlock<Number> total = block_of(fresnel_amplitudes(cosine, index));
        out.a = refracted ? out.a : total.a;
        out.b = refracted ? out.b : total.b;
        out.c = refracted ? out.c : total.c;
        out.d = refracted ? out.d : total.d;
    }
    return out;
}

/// The reflection for cosines of 0 to 1 and any index: a dielectric's, a metal's, or total reflection.
template <class Number>
[[gnu::always_inline]] inline ReflectionBlock<Number> reflection_block(
    const Number& cosine, const RelativeIndex<ScalarOf<Number>>& index) {
    return index.imaginary_square == 0 ? dielectric_reflection(cosine, index)
                                       : block_of(fresnel_amplitudes(cosine, index));
}

/// m(0, 0) and m(0, 1) of fresnel_transmission(), for positive cosines.
template <class Number>
[[gnu::always_inline]] inline void dielectric_transmission(const Number& cosine,
                                                           const RelativeIndex<ScalarOf<Number>>& index,
                                                           Number& mean, Number& difference) {
    const Number q2 = index.excess + cosine * cosine;
    Number q = q2 > 0.0F ? q2 : Number{};
    square_root(q);
    const Number s_sum = cosine + q;
    const Number p_sum = index.real_square * cosine + q;
    const Number power = 2.0F * cosine * q;
    const Number s = power / (s_sum * s_sum);
    const Number p = power * index.real_square / (p_sum * p_sum);
    mean = s + p;
    difference = s - p;
}

/// Mueller matrix of reflection for cosines of 0 to 1; both frames have x along the s-axis, z along the
/// propagation. `eta` is the relative index n - ik of the far side.
[[nodiscard]] Mueller fresnel_reflection(double cos_incident, std::complex<double> eta);

/// Returns the Mueller matrix of refraction into a dielectric of relative index eta > 0. The matrix includes
/// the power factor eta cos_t / cos_i. Both frames have x along the s-axis and z along the propagation. The
/// matrix is zero under total internal reflection. Refraction in the reverse direction at the refracted angle
/// has an equal matrix.
[[nodiscard]] Mueller fresnel_transmission(double cos_incident, double eta);

}  // namespace nicol
