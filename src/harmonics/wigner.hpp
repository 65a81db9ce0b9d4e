// SPDX-License-Identifier: MIT
// Wigner d matrices, all at once or one order after another.
#pragma once

#include <cstddef>
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

/// Highest order of wigner_d(), whose result has (order+1)(2 order+1)(2 order+3)/3 values.
inline constexpr int kMaxWignerOrder = 256;

/// Returns the start of block l in the result of wigner_d(): l (4 l^2 - 1) / 3.
[[nodiscard]] constexpr std::size_t wigner_offset(int l) {
    const auto n = static_cast<std::size_t>(l);
    return l == 0 ? 0 : n * (4 * n * n - 1) / 3;
}

/// Returns d^l_{mm'}(beta) for l = 0..order. Block l starts at wigner_offset(l), is (2l+1) x (2l+1), and has
/// row m + l and column m' + l. Convention: D^l_{mm'}(a, b, g) = exp(-i m a) d^l_{mm'}(b) exp(-i m' g) about
/// z, y, z, so that d^1_{10} = -sin(beta)/sqrt2. Throws Error(invalid_argument) for an order outside
/// 0..kMaxWignerOrder or a beta that is not finite.
[[nodiscard]] std::vector<double> wigner_d(int order, double beta);

}  // namespace nicol
