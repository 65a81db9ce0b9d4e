// SPDX-License-Identifier: MIT
// Fresnel's formulas at sixteen angles, in single precision.
#pragma once

#include <complex>

#include "polarization/view_geometry.hpp"

namespace nicol {

/// ReflectionBlock of each lane.
template <class Number>
struct LaneReflection {
    Number a, b, c, d;
};

/// An index n - ik relative to the outside, as the formulas below need it.
struct LaneIndex {
    explicit LaneIndex(std::complex<double> eta)
        : real_square(static_cast<float>((eta * eta).real())),
          imaginary_square(static_cast<float>((eta * eta).imag())),
          excess(static_cast<float>((eta * eta).real() - 1)) {}

    float real_square;  ///< of eta^2
    float imaginary_square;
    float excess;  ///< real_square - 1, without cancellation
};

/// Products of the amplitudes, each a complex number.
template <class Number>
[[gnu::always_inline]] inline LaneReflection<Number> reflection_of(const Number& s_real, const Number& s_imag,
                                                                   const Number& p_real,
                                                                   const Number& p_imag) {
    const Number s2 = s_real * s_real + s_imag * s_imag;
    const Number p2 = p_real * p_real + p_imag * p_imag;
    return {0.5F * (s2 + p2), 0.5F * (s2 - p2), p_real * s_real + p_imag * s_imag,
            p_imag * s_real - p_real * s_imag};
}

/// fresnel_reflection() of any index, a metal's or of total reflection, for cosines of 0 to 1.
template <class Number>
[[gnu::always_inline]] inline LaneReflection<Number> complex_reflection(const Number& cosine,
                                                                        const LaneIndex& index) {
    // q = eta cos_t, the square root of x + iy, y <= 0, whose imaginary part is negative.
    const Number x = index.excess + cosine * cosine;
    const float y = index.imaginary_square;
    Number q2 = x * x + y * y;
    square_root(q2);
    Number large = 0.5F * (q2 + (x > 0.0F ? x : -x));
    square_root(large);
    large = large > 1e-18F ? large : Number{} + 1e-18F;
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
    return reflection_of<Number>((cosine * cosine - q2) * s_scale, -2.0F * cosine * q_imag * s_scale,
                                 (e_real * e_real + e_imag * e_imag - q2) * p_scale,
                                 2.0F * (e_imag * q_real - e_real * q_imag) * p_scale);
}

/// The same of a real index.
template <class Number>
[[gnu::always_inline]] inline LaneReflection<Number> dielectric_reflection(const Number& cosine,
                                                                           const LaneIndex& index) {
    const Number q2 = index.excess + cosine * cosine;
    Number q = q2 > 0.0F ? q2 : Number{};
    square_root(q);
    // Differences of amplitudes by hand, which keeps the digits where the index is near 1.
    const Number s_sum = cosine + q;
    const Number p_sum = index.real_square * cosine + q;
    const Number s = -index.excess / (s_sum * s_sum);
    const Number p = index.excess * ((index.real_square + 1.0F) * cosine * cosine - 1.0F) / (p_sum * p_sum);
    LaneReflection<Number> out = reflection_of<Number>(s, Number{}, p, Number{});
    if (index.excess < 0) {
        const auto refracted = q2 > 0.0F;
        const LaneReflection<Number> total = complex_reflection(cosine, index);
        out.a = refracted ? out.a : total.a;
        out.b = refracted ? out.b : total.b;
        out.c = refracted ? out.c : total.c;
        out.d = refracted ? out.d : total.d;
    }
    return out;
}

/// m(0, 0) and m(0, 1) of fresnel_transmission(), for positive cosines.
template <class Number>
[[gnu::always_inline]] inline void dielectric_transmission(const Number& cosine, const LaneIndex& index,
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

}  // namespace nicol
