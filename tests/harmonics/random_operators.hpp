// SPDX-License-Identifier: MIT
// Random operators with the symmetries that real s0 and s3 ask for.
#pragma once

#include <algorithm>
#include <random>

#include "harmonics/operator.hpp"

namespace reference {

template <class Random>
nicol::IsotropicMatrix random_isotropic(Random& random, int order_out, int order_in) {
    std::normal_distribution<double> normal;
    nicol::IsotropicMatrix matrix(order_out, order_in);
    for (int m = 0; m <= std::min(order_out, order_in); ++m)
        for (int l = m; l <= order_out; ++l)
            for (int k = m; k <= order_in; ++k) {
                nicol::IsotropicMatrix::Block& b = matrix.block(m, l, k);
                for (std::size_t e = 0; e < 16; ++e) {
                    const bool spin_out = e / 4 >= 2;
                    const bool spin_in = e % 4 >= 2;
                    if ((spin_out && l < 2) || (spin_in && k < 2)) continue;
                    b[e] = {normal(random), m == 0 && !spin_out && !spin_in ? 0 : normal(random)};
                }
                if (m > 0) continue;
                // At m = 0 lanes 2 and 3 are conjugates of each other, and lanes 0 and 1 real.
                for (const std::size_t a : {0U, 1U}) {
                    b[4 * a + 3] = std::conj(b[4 * a + 2]);
                    b[12 + a] = std::conj(b[8 + a]);
                }
                b[15] = std::conj(b[10]);
                b[14] = std::conj(b[11]);
            }
    return matrix;
}

}  // namespace reference
