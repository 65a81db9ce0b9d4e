// SPDX-License-Identifier: MIT
// Spin-weighted spherical harmonics for a whole triangle of (l, m).
#pragma once

#include <complex>
#include <span>

#include "harmonics/psh.hpp"

namespace nicol {

/// Largest |spin| of spin_harmonics().
inline constexpr int kMaxSpin = 4;

/// Computes the real values sY_lm(theta, 0) = (-1)^s sqrt((2l+1)/4pi) d^l_{m,-s}(theta) (Eq. 176) for l =
/// 0..order, at out[psh_index(l, m)]; zero below l = |spin|. Other azimuths have the factor exp(i m phi). The
/// colatitude is given by sin(theta/2) and cos(theta/2), which keep every digit next to both poles: (0, 1) is
/// the north pole exactly, (1, 0) the south. The error is at most 5 l eps sqrt((2l+1)/4pi). Throws
/// Error(invalid_argument) for an order or spin out of range, an out of another size than psh_count(order),
/// and for a pair that is not on the unit circle.
void spin_harmonics(int spin, int order, double sin_half, double cos_half, std::span<double> out);

/// Computes the harmonics at a colatitude theta in [0, pi].
void spin_harmonics(int spin, int order, double theta, std::span<double> out);

/// Converts the coefficients of one scalar field over complex harmonics (Condon-Shortley phase) to
/// coefficients over real harmonics (Eqs. 12, 121 to 131): sqrt2 Re Y_lm for m > 0, Y_l0, sqrt2 Im Y_l|m| for
/// m < 0. The result is complex if the field is complex. Both spans have equal lengths, a square (m + l*l + l
/// runs over orders).
void real_from_complex(std::span<const std::complex<double>> coefficients,
                       std::span<std::complex<double>> out);

/// Computes the inverse of real_from_complex().
void complex_from_real(std::span<const std::complex<double>> coefficients,
                       std::span<std::complex<double>> out);

}  // namespace nicol
