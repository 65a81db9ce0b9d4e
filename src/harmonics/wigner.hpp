// SPDX-License-Identifier: MIT
// Wigner d matrices.
#pragma once

#include <cstddef>
#include <vector>

namespace nicol {

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
