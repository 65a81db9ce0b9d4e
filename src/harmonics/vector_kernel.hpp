// SPDX-License-Identifier: MIT
// The innermost loops of the folder, compiled once for each instruction set.
#pragma once

namespace nicol {

/// One order of a recursion over l at fixed degree and spin, y_{l+1} = (p - q t) y_l - c y_{l-1} with
/// t = 2 sin^2(theta/2), and the four real coefficients that multiply y_l.
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

/// Sums come in two sets of four, over even and odd steps; `split` false adds both sets into the first.
struct VectorKernel {
    /// out[set * 4 + k][ring] = sum over steps of f[k] y(ring); `stride` between the rows of out.
    void (*synthesize)(const LegendreStep* steps, int count, const LegendreRings& rings, bool split,
                       double* out, long stride);
    /// steps[i].f[k] = sum over rings of in[set * 4 + k][ring] y_i(ring).
    void (*analyze)(LegendreStep* steps, int count, const LegendreRings& rings, bool split, const double* in,
                    long stride);
    /// One stage of a Fourier transform of eight sequences (layout of BatchFft): radix `factor`, `left`
    /// groups, `stride` elements in each. Twiddles [group][1..factor-1] and roots of unity as pairs (re, im).
    void (*fft_stage)(const double* in, double* out, int factor, int left, int stride, const double* twiddles,
                      const double* roots);
    /// out[row] = sum over columns of d[row * width + column] in[column], in and out in groups of four.
    void (*multiply_lanes)(int width, const double* d, const double* in, double* out);
    /// Adds to sums[2 m] and sums[2 m + 1] (groups of four), m = 0..degrees-1, the sums over i < count of
    /// table[2 (m count + i)] cosine_(m % 2)[i] and table[2 (m count + i) + 1] sine_(m % 2)[i]; `folded`
    /// holds cosine_0, cosine_1, sine_0 and sine_1, each of `count` groups of four.
    void (*low_degrees)(const double* folded, int count, const double* table, int degrees, double* sums);
};

/// The fastest this processor can run.
const VectorKernel& vector_kernel();

/// All it can run, slowest first.
int vector_kernel_count();
const VectorKernel& vector_kernel(int i);

}  // namespace nicol
