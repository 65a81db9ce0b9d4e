// SPDX-License-Identifier: MIT
// Wigner 3j symbols and integrals of three spin harmonics.
#pragma once

#include <vector>

namespace nicol {

/// Every 3j symbol (l1 l2 l3; -m2-m3, m2, m3) with the same l2, l3, m2, m3.
struct Wigner3jRun {
    int first_l1 = 0;           ///< max(|l2 - l3|, |m2 + m3|)
    std::vector<double> value;  ///< by l1 = first_l1 .. l2 + l3

    /// Zero outside the triangle.
    [[nodiscard]] double at(int l1) const;
};

/// By the three-term recursion in l1 from both ends towards the middle, so that small values at either end
/// keep their relative accuracy. Throws Error(invalid_argument) unless 0 <= l <= kMaxOrder and |m| <= l for
/// both.
[[nodiscard]] Wigner3jRun wigner_3j_run(int l2, int l3, int m2, int m3);

/// A single symbol (l1 l2 l3; m1 m2 m3); zero where the selection rules say so. Throws for a negative l.
[[nodiscard]] double wigner_3j(int l1, int l2, int l3, int m1, int m2, int m3);

/// Integral over the sphere of conj(s1Y_l1m1) s2Y_l2m2 s3Y_l3m3 with s1 = s2 + s3:
/// (-1)^(m1+s1) sqrt((2l1+1)(2l2+1)(2l3+1)/4pi) (l1 l2 l3; -m1 m2 m3)(l1 l2 l3; s1 -s2 -s3). With (s1, s2,
/// s3) = (0, 0, 0) this is Eq. 215; with (2, 0, 2) it is Eq. 216, whose printed second symbol (-2 0 2) holds
/// only for even l1 + l2 + l3. Throws Error(invalid_argument) for spins that do not add up or a negative l.
[[nodiscard]] double triple_product(int s1, int l1, int m1, int s2, int l2, int m2, int s3, int l3, int m3);

}  // namespace nicol
