// SPDX-License-Identifier: MIT
// Mirror symmetry of isotropic operators. The mirror image in the plane y = 0 takes blocks to their
// conjugates and changes the sign of the lane of s3. In a symmetric operator, elements that mix s3 with the
// other lanes are therefore imaginary, and the rest is real.
#include "harmonics/mirror_symmetry.hpp"

#include <algorithm>
#include <cmath>

namespace nicol {
namespace {

using Complex = std::complex<double>;

Complex symmetric_part(std::size_t element, Complex value) {
    const bool imaginary = (element / 4 == 1) != (element % 4 == 1);
    return imaginary ? Complex(0, value.imag()) : Complex(value.real(), 0);
}

}  // namespace

// A scalar pair of degrees +-m is one complex number of 1/sqrt2 its length. At m = 0 the last lane repeats
// the third.
double block_weight(int m, std::size_t out, std::size_t in) {
    const bool scalar_out = out < 2;
    const bool scalar_in = in < 2;
    if (m > 0) return 2 * (scalar_out ? 2.0 : 1.0) / (scalar_in ? 2.0 : 1.0);
    if (out == 3) return 0;
    if (scalar_out) return scalar_in ? 1 : 2;
    return scalar_in ? 1 : 2;
}

double asymmetry(const IsotropicMatrix& matrix) {
    double wrong = 0;
    double all = 0;
    for (int m = 0; m <= std::min(matrix.order_out(), matrix.order_in()); ++m) {
        for (const IsotropicMatrix::Block& block : matrix.blocks(m)) {
            for (std::size_t e = 0; e < 16; ++e) {
                const double weight = block_weight(m, e / 4, e % 4);
                all += weight * std::norm(block[e]);
                wrong += weight * std::norm(block[e] - symmetric_part(e, block[e]));
            }
        }
    }
    return all > 0 ? std::sqrt(wrong / all) : 0;
}

void symmetrize(IsotropicMatrix& matrix) {
    for (int m = 0; m <= std::min(matrix.order_out(), matrix.order_in()); ++m)
        for (IsotropicMatrix::Block& block : matrix.blocks(m))
            for (std::size_t e = 0; e < 16; ++e) block[e] = symmetric_part(e, block[e]);
}

}  // namespace nicol
