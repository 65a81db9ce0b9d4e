// SPDX-License-Identifier: MIT
// Fourier coefficients of a few low degrees of a long row, without a whole transform.
#pragma once

#include <complex>
#include <span>
#include <vector>

namespace nicol {

/// Adds to sums[2 m] and sums[2 m + 1] (groups of four), m = 0..degrees-1, the sums over i < count of
/// table[2 (m count + i)] cosine_(m % 2)[i] and table[2 (m count + i) + 1] sine_(m % 2)[i]; `folded`
/// holds cosine_0, cosine_1, sine_0 and sine_1, each of `count` groups of four.
void add_low_degrees(const double* folded, int count, const double* table, int degrees, double* sums);

/// Fourier sums of a row. The four points of the row that are mirror images of each other in the axes share
/// their cosines and sines, so a degree costs half a multiplication per sample and component.
class LowDegrees {
public:
    /// Returns whether the sums are faster than a transform.
    [[nodiscard]] static bool suits(int order, int columns) {
        return columns % 4 == 0 && columns >= 8 * order && columns >= 64 && order <= 64;
    }

    LowDegrees(int order, int columns);

    /// Returns the sums over c of samples[c][p] cos(2 pi m c / columns) at [2 m][p], and of the product with
    /// the sine at [2 m + 1][p].
    std::span<const double> sums(std::span<const double> samples);

private:
    static constexpr int kBlock = 64;

    int order_;
    int columns_;
    std::vector<double> table_;   // by block: [m][i] cos, sin
    std::vector<double> folded_;  // [4][block][4]
    std::vector<double> sums_;
};

}  // namespace nicol
