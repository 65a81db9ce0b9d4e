// SPDX-License-Identifier: MIT
// Discrete Fourier sums of a few degrees for four periodic rows at once.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace nicol {

/// Four sequences of floats that are summed together: the Stokes components of a row, or four rows of s0.
/// Element c of sequence k is first[k][c * stride].
struct FourRows {
    std::array<const float*, 4> first;
    std::size_t stride;
};

/// Fourier sums of folded rows. The four pixels of a row that are mirror images of each other in the axes
/// share their cosines and sines, so a degree costs half a multiplication per value. Not thread-safe; copies
/// are independent.
class FoldedSums {
public:
    /// Returns whether rows of `columns` columns are supported and the sums faster than an FFT.
    [[nodiscard]] static bool suits(int order, int columns) {
        return columns % 4 == 0 && order <= 128 && columns >= 16;
    }

    FoldedSums(int order, int columns);

    /// Returns, with a_c = 2 pi (c + 1/2) / columns and m = 0..order, the sums over c of value cos(m a_c) of
    /// sequence k at [8 m + k], and of value sin(m a_c) at [8 m + 4 + k]. Valid until the next call.
    [[nodiscard]] std::span<const double> operator()(const FourRows& rows);

private:
    void fold(const FourRows& rows, std::size_t first, std::size_t count);

    int order_;
    std::size_t columns_;
    std::vector<double> table_;   // by block of columns: [m][i] cosine, sine
    std::vector<double> folded_;  // even and odd cosines, even and odd sines: [4][i][k]
    std::vector<double> sums_;
};

}  // namespace nicol
