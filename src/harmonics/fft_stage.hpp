// SPDX-License-Identifier: MIT
// The innermost loop of BatchFft.
#pragma once

namespace nicol {

/// One stage of a Fourier transform of eight sequences (layout of BatchFft): radix `factor`, `left` groups,
/// `stride` elements in each. Twiddles [group][1..factor-1] and roots of unity as pairs (re, im). Other
/// factors than 2, 3, 4, 5 and 7 are odd and at most 63.
void fft_stage(const double* in, double* out, int factor, int left, int stride, const double* twiddles,
               const double* roots);

}  // namespace nicol
