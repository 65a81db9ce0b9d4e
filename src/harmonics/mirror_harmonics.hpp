// SPDX-License-Identifier: MIT
// Harmonics of LightLayout as functions of theta times functions of phi.
#pragma once

#include <vector>

#include "harmonics/grid.hpp"
#include "harmonics/light_layout.hpp"

namespace nicol {

/// Gauss-Legendre rows of the upper half, and the equator if it is a row. All integrands are equal above and
/// below.
class UpperRows {
public:
    /// Takes the upper half of `count` rows on the whole sphere.
    explicit UpperRows(int count) : rows_(gauss_legendre_rows(count)) {}

    [[nodiscard]] std::size_t count() const noexcept { return (rows_.theta.size() + 1) / 2; }
    [[nodiscard]] double sin_half(std::size_t row) const { return rows_.sin_half[row]; }
    [[nodiscard]] double cos_half(std::size_t row) const { return rows_.cos_half[row]; }
    /// Returns the weight of a row for the integral over cos(theta) of both halves.
    [[nodiscard]] double weight(std::size_t row) const {
        return rows_.weight[row] * (2 * row + 1 == rows_.theta.size() ? 1 : 2);
    }

private:
    LatitudeRows rows_;
};

/// Harmonic as a product of functions. `first` is s0, s3 or s1 on each row; it goes with cos m phi for m >= 0
/// and sin |m| phi for m < 0. `second` is s2, only for spin harmonics; it goes with degree
/// other_trigonometric(m).
struct SeparatedHarmonic {
    int m;
    std::vector<double> first;
    std::vector<double> second;
};

/// Returns the degree with sine in place of cosine and cosine in place of sine: -m for m > 0, |m| else.
[[nodiscard]] constexpr int other_trigonometric(int m) {
    return -m;
}

[[nodiscard]] std::vector<SeparatedHarmonic> separate_scalars(
    const std::vector<LightLayout::Harmonic>& harmonics, const UpperRows& rows);
[[nodiscard]] std::vector<SeparatedHarmonic> separate_spins(
    const std::vector<LightLayout::Harmonic>& harmonics, const UpperRows& rows);

/// Returns the highest l; 0 if there are no harmonics.
[[nodiscard]] int highest_order(const std::vector<LightLayout::Harmonic>& harmonics);

}  // namespace nicol
