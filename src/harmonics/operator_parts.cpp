// SPDX-License-Identifier: MIT
// Operators made from others.
#include <algorithm>

#include "harmonics/isotropic_lanes.hpp"
#include "harmonics/operator.hpp"
#include "harmonics/rotation.hpp"

namespace nicol {

CoefficientMatrix rotation_matrix(int order, const glm::dmat3& rotation) {
    CoefficientMatrix out(order, order);
    // Row by row of the identity: rotated unit vectors are the columns.
    std::vector<double> columns(out.data().size());
    for (std::size_t i = 0; i < out.rows(); ++i) columns[i * out.columns() + i] = 1;
    PshRotation(order, rotation).apply(columns, columns);
    for (std::size_t i = 0; i < out.rows(); ++i)
        for (std::size_t j = 0; j < out.columns(); ++j) out(i, j) = columns[j * out.rows() + i];
    return out;
}

IsotropicMatrix isotropic_part(const CoefficientMatrix& matrix) {
    using Complex = std::complex<double>;
    IsotropicMatrix out(matrix.order_out(), matrix.order_in());
    std::vector<double> in(matrix.columns());
    std::vector<double> response(matrix.rows());
    for (int m = 0; m <= std::min(matrix.order_out(), matrix.order_in()); ++m)
        for (int l = m; l <= matrix.order_out(); ++l)
            for (int k = m; k <= matrix.order_in(); ++k) {
                // Degrees m and -m, or 0 once.
                const int step = m == 0 ? 1 : 2 * m;
                const auto respond = [&](std::size_t lane, Complex value) {
                    IsotropicLanes unit{};
                    unit[lane] = value;
                    store_lanes(unit, in, k, m);
                    for (int row = -m; row <= m; row += step)
                        for (std::size_t p = 0; p < 4; ++p) {
                            const std::size_t i = 4 * psh_index(l, row) + p;
                            response[i] = 0;
                            for (int column = -m; column <= m; column += step)
                                for (std::size_t q = 0; q < 4; ++q) {
                                    const std::size_t j = 4 * psh_index(k, column) + q;
                                    response[i] += matrix(i, j) * in[j];
                                }
                        }
                    return load_lanes(response, l, m);
                };
                IsotropicMatrix::Block& block = out.block(m, l, k);
                for (std::size_t b = 0; b < 4; ++b) {
                    if (m == 0 && b == 3) continue;
                    const IsotropicLanes one = respond(b, 1);
                    if (m == 0 && b < 2) {
                        for (std::size_t a = 0; a < 4; ++a) block[4 * a + b] = one[a];
                        continue;
                    }
                    // The part that commutes with multiplication by i, which is what a rotation about z is;
                    // at m = 0 the rest is the response to the conjugate in lane 3.
                    const IsotropicLanes rotated = respond(b, Complex(0, 1));
                    for (std::size_t a = 0; a < 4; ++a) {
                        const Complex rest = Complex(0, 1) * rotated[a];
                        block[4 * a + b] = 0.5 * (one[a] - rest);
                        if (m == 0) block[4 * a + 3] = 0.5 * (one[a] + rest);
                    }
                }
            }
    return out;
}

}  // namespace nicol
