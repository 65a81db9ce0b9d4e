// SPDX-License-Identifier: MIT
// The four complex numbers of (l, m >= 0) that an isotropic operator mixes.
#pragma once

#include <array>
#include <complex>
#include <numbers>
#include <span>

#include "harmonics/require.hpp"

namespace nicol {

/// Coefficients s0_lm and s3_lm over complex harmonics, w_lm, conj(w_l-m). A rotation by a about z multiplies
/// all four by exp(-i m a).
using IsotropicLanes = std::array<std::complex<double>, 4>;

inline IsotropicLanes load_lanes(std::span<const double> f, int l, int m) {
    const double* p = &f[4 * psh_index(l, m)];
    const double* n = &f[4 * psh_index(l, -m)];
    const double half = m == 0 ? 1 : std::numbers::sqrt2 / 2;
    const double sine = m == 0 ? 0 : -half;
    return {{{half * p[0], sine * n[0]}, {half * p[3], sine * n[3]}, {p[1], p[2]}, {n[1], -n[2]}}};
}

inline void store_lanes(const IsotropicLanes& lanes, std::span<double> f, int l, int m) {
    double* p = &f[4 * psh_index(l, m)];
    double* n = &f[4 * psh_index(l, -m)];
    if (m > 0) {
        n[0] = -std::numbers::sqrt2 * lanes[0].imag();
        n[3] = -std::numbers::sqrt2 * lanes[1].imag();
        n[1] = lanes[3].real();
        n[2] = -lanes[3].imag();
    }
    const double scale = m == 0 ? 1 : std::numbers::sqrt2;
    p[0] = scale * lanes[0].real();
    p[3] = scale * lanes[1].real();
    p[1] = lanes[2].real();
    p[2] = lanes[2].imag();
}

/// Adds a b to sum, without the special cases of infinities that std::complex must honour.
inline void multiply_add(std::complex<double>& sum, std::complex<double> a, std::complex<double> b) {
    sum = {sum.real() + (a.real() * b.real() - a.imag() * b.imag()),
           sum.imag() + (a.real() * b.imag() + a.imag() * b.real())};
}

}  // namespace nicol
