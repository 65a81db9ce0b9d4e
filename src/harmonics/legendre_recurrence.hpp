// SPDX-License-Identifier: MIT
// The innermost loops of the Legendre step: a recurrence over l at fixed degree and spin, on many rings of
// latitude.
#pragma once

namespace nicol {

/// Step of one order: y_{l+1} = (p - q t) y_l - c y_{l-1} with t = 2 sin^2(theta/2), and the four real
/// coefficients that multiply y_l.
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

/// Computes out[set * 4 + k][ring] = sum over steps of f[k] y(ring); `stride` is the distance between the
/// rows of out. Sums come in two sets of four, over even and odd steps; without `split` both are added into
/// the first set.
void synthesize(const LegendreStep* steps, int count, const LegendreRings& rings, bool split, double* out,
                long stride);

/// Computes steps[i].f[k] = sum over rings of in[set * 4 + k][ring] y_i(ring), with the sets of synthesize().
void analyze(LegendreStep* steps, int count, const LegendreRings& rings, bool split, const double* in,
             long stride);

}  // namespace nicol
