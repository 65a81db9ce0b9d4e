// SPDX-License-Identifier: MIT
// All d^l_{mn}(beta), one order after another.
#pragma once

#include <cstdint>
#include <vector>

#include "harmonics/scaled.hpp"

namespace nicol {

/// Sweep over orders that holds d^l for m >= |n| (the rest follows by symmetry) and steps l by the three-term
/// recursion; O(l^2) memory and work per step. The product with the scale keeps entries that start below the
/// range of double.
class WignerSweep {
public:
    /// Starts at l = 0. Must not be stepped beyond `order`.
    WignerSweep(int order, HalfAngle half);

    [[nodiscard]] int l() const { return l_; }
    /// Moves to the next order.
    void step();
    /// Writes the whole block, (2l+1)^2 values, row m + l, column n + l.
    void block(double* out) const;

private:
    void start_row(int m);
    void rescale_row(int m);
    [[nodiscard]] bool north() const { return half_.sin <= half_.cos; }

    HalfAngle half_;
    int l_ = 0;
    std::vector<double> current_;  // [psh_index(m, n)]
    std::vector<double> previous_;
    std::vector<std::int16_t> exponent_;  // exponent of 2^256; 0 if settled
    std::vector<int> unsettled_;          // number of entries of a row whose exponent is not 0
    std::vector<double> root_;            // sqrt(l^2 - n^2), by n
    std::vector<double> next_root_;
    std::vector<double> change_;  // last change of the entry that does not vanish at the nearer pole
    Scaled edge_;                 // max(sin, cos)^(2m)
};

}  // namespace nicol
