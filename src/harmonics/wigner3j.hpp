// SPDX-License-Identifier: MIT
// Wigner 3j symbols.
#pragma once

#include <vector>

namespace nicol {

/// All 3j symbols (l1 l2 l3; -m2-m3, m2, m3) with equal l2, l3, m2, m3.
struct Wigner3jRun {
    int first_l1 = 0;           ///< max(|l2 - l3|, |m2 + m3|)
    std::vector<double> value;  ///< by l1 = first_l1 .. l2 + l3

    /// Returns the symbol of l1; zero outside the triangle.
    [[nodiscard]] double at(int l1) const;
};

/// Computes the symbols by the three-term recursion in l1 from both ends towards the middle, so that small
/// values at either end keep their relative accuracy. Throws Error(invalid_argument) unless 0 <= l <=
/// kMaxOrder and |m| <= l for both.
[[nodiscard]] Wigner3jRun wigner_3j_run(int l2, int l3, int m2, int m3);

}  // namespace nicol
