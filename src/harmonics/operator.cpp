// SPDX-License-Identifier: MIT
// Linear operators on Stokes vector fields: storage, product, composition, and the mirror symmetry of
// isotropic ones.
#include "harmonics/operator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "harmonics/isotropic_lanes.hpp"

namespace nicol {

CoefficientMatrix::CoefficientMatrix(int order_out, int order_in)
    : order_out_(order_out), order_in_(order_in) {
    for (const int order : {order_out, order_in})
        require(order >= 0 && order <= kMaxDenseOrder, "order is " + std::to_string(order) +
                                                           ", a dense matrix takes 0 to " +
                                                           std::to_string(kMaxDenseOrder));
    data_.assign(rows() * columns(), 0.0);
}

void CoefficientMatrix::apply(std::span<const double> in, std::span<double> out) const {
    require_size(in.size(), columns(), "in");
    require_size(out.size(), rows(), "out");
    const double* row = data_.data();
    for (double& value : out) {
        double sum[4] = {0, 0, 0, 0};
        for (std::size_t i = 0; i < in.size(); i += 4)
            for (std::size_t p = 0; p < 4; ++p) sum[p] += row[i + p] * in[i + p];
        value = (sum[0] + sum[1]) + (sum[2] + sum[3]);
        row += in.size();
    }
}

CoefficientMatrix compose(const CoefficientMatrix& second, const CoefficientMatrix& first) {
    require(second.order_in() == first.order_out(),
            "the second operator takes order " + std::to_string(second.order_in()) + ", the first gives " +
                std::to_string(first.order_out()));
    CoefficientMatrix out(second.order_out(), first.order_in());
    for (std::size_t i = 0; i < out.rows(); ++i)
        for (std::size_t k = 0; k < first.rows(); ++k) {
            const double factor = second(i, k);
            if (factor == 0) continue;
            for (std::size_t j = 0; j < out.columns(); ++j) out(i, j) += factor * first(k, j);
        }
    return out;
}

IsotropicMatrix::IsotropicMatrix(int order_out, int order_in) : order_out_(order_out), order_in_(order_in) {
    require_order(order_out);
    require_order(order_in);
    std::size_t total = 0;
    for (int m = 0; m <= std::min(order_out, order_in); ++m) {
        first_.push_back(total);
        total += count(m);
    }
    blocks_.resize(total);
}

void IsotropicMatrix::apply(std::span<const double> in, std::span<double> out) const {
    require(order_out_ >= 0, "the matrix is empty");
    require_size(in.size(), 4 * psh_count(order_in_), "in");
    require_size(out.size(), 4 * psh_count(order_out_), "out");
    std::ranges::fill(out, 0.0);
    std::vector<IsotropicLanes> from(static_cast<std::size_t>(order_in_) + 1);
    for (int m = 0; m <= std::min(order_out_, order_in_); ++m) {
        for (int l = m; l <= order_in_; ++l) from[static_cast<std::size_t>(l - m)] = load_lanes(in, l, m);
        for (int l = m; l <= order_out_; ++l) {
            const Block* row = &block(m, l, m);
            IsotropicLanes sum{};
            for (int k = 0; k <= order_in_ - m; ++k)
                for (std::size_t a = 0; a < 4; ++a)
                    for (std::size_t b = 0; b < 4; ++b)
                        multiply_add(sum[a], row[k][4 * a + b], from[static_cast<std::size_t>(k)][b]);
            store_lanes(sum, out, l, m);
        }
    }
}

CoefficientMatrix IsotropicMatrix::dense() const {
    CoefficientMatrix out(order_out_, order_in_);
    std::vector<double> unit(out.columns());
    std::vector<double> column(out.rows());
    for (std::size_t j = 0; j < unit.size(); ++j) {
        unit[j] = 1;
        apply(unit, column);
        unit[j] = 0;
        for (std::size_t i = 0; i < column.size(); ++i) out(i, j) = column[i];
    }
    return out;
}

IsotropicMatrix compose(const IsotropicMatrix& second, const IsotropicMatrix& first) {
    require(second.order_in() == first.order_out() && first.order_in() >= 0,
            "the second operator takes order " + std::to_string(second.order_in()) + ", the first gives " +
                std::to_string(first.order_out()));
    IsotropicMatrix out(second.order_out(), first.order_in());
    for (int m = 0; m <= std::min({second.order_out(), second.order_in(), first.order_in()}); ++m)
        for (int i = m; i <= second.order_out(); ++i)
            for (int k = m; k <= second.order_in(); ++k)
                for (int j = m; j <= first.order_in(); ++j) {
                    const IsotropicMatrix::Block& x = second.block(m, i, k);
                    const IsotropicMatrix::Block& y = first.block(m, k, j);
                    IsotropicMatrix::Block& z = out.block(m, i, j);
                    for (std::size_t a = 0; a < 4; ++a)
                        for (std::size_t c = 0; c < 4; ++c)
                            for (std::size_t b = 0; b < 4; ++b)
                                multiply_add(z[4 * a + b], x[4 * a + c], y[4 * c + b]);
                }
    return out;
}

IsotropicMatrix reflection_matrix(int order) {
    IsotropicMatrix out(order, order);
    for (int m = 0; m <= order; ++m)
        for (int l = m; l <= order; ++l) {
            IsotropicMatrix::Block& b = out.block(m, l, l);
            b[0] = parity(l + m);
            b[5] = -parity(l + m);
            b[11] = b[14] = l >= 2 ? parity(l) : 0;
        }
    return out;
}

PshVector reflected(const PshVector& field) {
    require_finite(field.data(), "field");
    PshVector out = field;
    for (int c = 0; c < field.channels(); ++c) {
        const auto f = field.channel(c);
        const auto g = out.channel(c);
        for (int l = 0; l <= field.order(); ++l)
            for (int m = -l; m <= l; ++m) {
                const std::size_t i = 4 * psh_index(l, m);
                const std::size_t j = 4 * psh_index(l, -m);
                g[i] = parity(l + m) * f[i];
                g[i + 1] = parity(l) * f[j + 1];
                g[i + 2] = -parity(l) * f[j + 2];
                g[i + 3] = -parity(l + m) * f[i + 3];
            }
    }
    return out;
}

namespace {

using Complex = std::complex<double>;

/// Returns the part of an element that has mirror symmetry. The mirror image in the plane y = 0 takes blocks
/// to their conjugates and changes the sign of the lane of s3. In a symmetric operator, elements that mix s3
/// with the other lanes are therefore imaginary, and the rest is real.
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
