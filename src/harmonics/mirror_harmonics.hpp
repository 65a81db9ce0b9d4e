// SPDX-License-Identifier: MIT
// The harmonics of LightLayout as functions of theta times functions of phi.
#pragma once

#include <vector>

#include "harmonics/grid.hpp"
#include "harmonics/light_layout.hpp"

namespace nicol {

/// The Gauss-Legendre rows of the upper half, and the equator where there is one; all integrands are the same
/// above and below.
class UpperRows {
public:
    /// `count` rows on the whole sphere.
    explicit UpperRows(int count) : rows_(gauss_legendre_rows(count)) {}

    [[nodiscard]] std::size_t count() const noexcept { return (rows_.theta.size() + 1) / 2; }
    [[nodiscard]] double sin_half(std::size_t row) const { return rows_.sin_half[row]; }
    [[nodiscard]] double cos_half(std::size_t row) const { return rows_.cos_half[row]; }
    /// For the integral over cos(theta) of both halves.
    [[nodiscard]] double weight(std::size_t row) const {
        return rows_.weight[row] * (2 * row + 1 == rows_.theta.size() ? 1 : 2);
    }

private:
    LatitudeRows rows_;
};

/// One harmonic. `first` is s0, s3 or s1 on each row; it goes with cos m phi for m >= 0 and sin |m| phi for
/// m < 0. `second`, of spin harmonics alone, is s2; it goes with degree other_trigonometric(m).
struct SeparatedHarmonic {
    int m;
    std::vector<double> first;
    std::vector<double> second;
};

/// Sine for cosine: -m for m > 0, |m| else.
[[nodiscard]] constexpr int other_trigonometric(int m) {
    return -m;
}

[[nodiscard]] std::vector<SeparatedHarmonic> separate_scalars(
    const std::vector<LightLayout::Harmonic>& harmonics, const UpperRows& rows);
[[nodiscard]] std::vector<SeparatedHarmonic> separate_spins(
    const std::vector<LightLayout::Harmonic>& harmonics, const UpperRows& rows);

/// The highest l; 0 where there are none.
[[nodiscard]] int highest_order(const std::vector<LightLayout::Harmonic>& harmonics);

}  // namespace nicol
