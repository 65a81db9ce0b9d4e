// SPDX-License-Identifier: MIT
// The innermost loops of the Legendre step: a recurrence over l at fixed degree and spin, on many rings of
// latitude.
#pragma once

namespace nicol {

/// One order of y_{l+1} = (p - q t) y_l - c y_{l-1} with t = 2 sin^2(theta/2), and the four real coefficients
/// that multiply y_l.
struct LegendreStep {
    double p, q, c, unused;
    double f[4];
};

/// Rings of latitude in structure-of-arrays form; `rings` is a multiple of kRingLanes. The first y is
/// value * 2^(256 exponent).
struct LegendreRings {
    const double* t;
    const double* value;
    const int* exponent;
    int rings;
};

inline constexpr int kRingLanes = 8;

/// out[set * 4 + k][ring] = sum over steps of f[k] y(ring); `stride` between the rows of out. Sums come in
/// two sets of four, over even and odd steps; `split` false adds both into the first.
void synthesize(const LegendreStep* steps, int count, const LegendreRings& rings, bool split, double* out,
                long stride);

/// steps[i].f[k] = sum over rings of in[set * 4 + k][ring] y_i(ring), sets as in synthesize().
void analyze(LegendreStep* steps, int count, const LegendreRings& rings, bool split, const double* in,
             long stride);

}  // namespace nicol
