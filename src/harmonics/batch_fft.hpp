// SPDX-License-Identifier: MIT
// Complex Fourier transforms of eight sequences at once, with one sequence in each lane.
#pragma once

#include <complex>
#include <cstddef>
#include <vector>

namespace nicol {

/// Fourier transform of any length. Large prime factors are transformed by a chirp (Bluestein). Element i of
/// the eight sequences lies at [16 i .. 16 i + 7] (real) and [16 i + 8 .. 16 i + 15] (imaginary).
class BatchFft {
public:
    static constexpr std::size_t kLanes = 8;
    static constexpr std::size_t kElement = 2 * kLanes;

    explicit BatchFft(int length);

    /// Computes out_k = sum_n in_n exp(-2 pi i n k / length). Uses `data` as work space and returns a pointer
    /// to the result, which is in `data` or in the object.
    const double* forward(double* data);

private:
    struct Factorised {
        int length = 0;
        std::vector<int> factors;
        std::vector<std::vector<std::complex<double>>> twiddles;  // by stage, [k][j], j = 1..factor-1
        std::vector<std::vector<std::complex<double>>> roots;     // by stage, exp(-2 pi i j / factor)

        explicit Factorised(int n);
        /// Returns `a` or `b`, whichever holds the result.
        double* run(double* a, double* b) const;
    };

    Factorised direct_;
    std::vector<double> other_;
    // Bluestein's chirp exp(-pi i n^2 / length), and the transform of its conjugate over a longer product of
    // 2, 3 and 5.
    std::vector<std::complex<double>> chirp_;
    std::vector<std::complex<double>> chirp_transform_;
    std::vector<double> long_a_;
    std::vector<double> long_b_;
};

}  // namespace nicol
