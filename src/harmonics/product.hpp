// SPDX-License-Identifier: MIT
// Products of a scalar field, such as visibility, and a Stokes vector field.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "harmonics/operator.hpp"
#include "harmonics/psh.hpp"
#include "harmonics/transform.hpp"

namespace nicol {

/// Expansion of a scalar field into the matrix that multiplies by it (Eq. 54), from integrals of triple
/// products that are computed once. Exact for a scalar field of order scalar_order; orders above order_out +
/// order_in have no effect.
class ShadowMatrix {
public:
    /// Throws Error(invalid_argument) for orders outside 0..CoefficientMatrix::kMaxDenseOrder (scalar_order:
    /// twice that).
    ShadowMatrix(int scalar_order, int order_out, int order_in);

    /// Returns the matrix of a scalar field. scalar: psh_count(scalar_order) coefficients over real
    /// harmonics. The matrix has only 0-0 and 2-2 blocks.
    [[nodiscard]] CoefficientMatrix expand(std::span<const double> scalar) const;

private:
    struct Run {
        int first = 0;           // lowest order of the scalar field
        std::size_t offset = 0;  // index in spin0_ and spin2_
        int count = 0;
    };

    int scalar_order_;
    int order_out_;
    int order_in_;
    std::vector<Run> runs_;  // by (l_out, m_out), (l_in, m_in)
    std::vector<double> spin0_;
    std::vector<double> spin2_;
};

/// Product of two fields, computed on a grid: exact if the factors have the given orders, O(L^3), no matrix.
/// Holds its work space; not for use by two threads at once.
class PshProduct {
public:
    /// Makes a product with coefficients up to order_out; higher orders are cut. Throws
    /// Error(invalid_argument) for an order out of range.
    PshProduct(int scalar_order, int field_order, int order_out);

    /// Multiplies two fields. scalar: psh_count(scalar_order) coefficients over real harmonics; field and
    /// out: one channel.
    void multiply(std::span<const double> scalar, std::span<const double> field, std::span<double> out);

private:
    PshTransform scalar_transform_;
    PshTransform field_transform_;
    PshTransform out_transform_;
    std::vector<double> scalar_coefficients_;
    std::vector<double> scalar_samples_;
    std::vector<double> field_samples_;
};

}  // namespace nicol
