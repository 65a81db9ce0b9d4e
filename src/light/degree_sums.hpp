// SPDX-License-Identifier: MIT
// Discrete Fourier sums of a periodic row at the degrees -order..order.
#pragma once

#include <kissfft/kissfft.hh>

#include <complex>
#include <span>
#include <vector>

namespace nicol {

/// sum_c z_c exp(-i m phi_c) with phi_c = phi0 + 2 pi c / columns, for any order: also above columns / 2,
/// where the plain sums repeat. One object a thread.
class DegreeSums {
public:
    DegreeSums(int order, int columns, double phi0);

    /// row: columns values; sums[m + order], m = -order..order.
    void operator()(std::span<const std::complex<double>> row, std::span<std::complex<double>> sums);

private:
    int order_;
    int columns_;
    bool direct_;
    kissfft<double> fft_;
    std::vector<std::complex<double>> phase_;  // exp(-i m phi0), m = -order..order
    std::vector<std::complex<double>> bins_;   // of the FFT, or the roots of unity of the direct sum
};

}  // namespace nicol
