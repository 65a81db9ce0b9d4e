// SPDX-License-Identifier: MIT
// Random operators with the symmetries that real s0 and s3 require.
#pragma once

#include <algorithm>
#include <array>
#include <complex>
#include <random>

#include "harmonics/convolution.hpp"
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
                // At m = 0 lanes 2 and 3 are complex conjugates, and lanes 0 and 1 are real.
                for (const std::size_t a : {0U, 1U}) {
                    b[4 * a + 3] = std::conj(b[4 * a + 2]);
                    b[12 + a] = std::conj(b[8 + a]);
                }
                b[15] = std::conj(b[10]);
                b[14] = std::conj(b[11]);
            }
    return matrix;
}

/// Returns all numbers of one order of a kernel. The first four are real.
inline std::array<std::complex<double>, 10> parts_of(const nicol::KernelBand& k) {
    return {k.k00, k.k03, k.k30, k.k33, k.p0, k.p3, k.from_p0, k.from_p3, k.iso, k.conj};
}

template <class Random>
nicol::ConvolutionKernel random_kernel(Random& random, int order) {
    std::normal_distribution<double> normal;
    const auto complex = [&] { return std::complex{normal(random), normal(random)}; };
    nicol::ConvolutionKernel out(static_cast<std::size_t>(order) + 1);
    for (std::size_t l = 0; l < out.size(); ++l) {
        for (double* part : {&out[l].k00, &out[l].k03, &out[l].k30, &out[l].k33}) *part = normal(random);
        if (l < 2) continue;
        for (auto* part :
             {&out[l].p0, &out[l].p3, &out[l].from_p0, &out[l].from_p3, &out[l].iso, &out[l].conj})
            *part = complex();
    }
    return out;
}

/// Returns the largest difference between the parts of two kernels of equal order.
inline double kernel_difference(const nicol::ConvolutionKernel& a, const nicol::ConvolutionKernel& b) {
    double most = a.size() == b.size() ? 0 : HUGE_VAL;
    for (std::size_t l = 0; l < std::min(a.size(), b.size()); ++l)
        for (std::size_t i = 0; i < 10; ++i)
            most = std::max(most, std::abs(parts_of(a[l])[i] - parts_of(b[l])[i]));
    return most;
}

}  // namespace reference
