// SPDX-License-Identifier: MIT
// A scalar field, such as visibility, times a Stokes vector field.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "harmonics/operator.hpp"
#include "harmonics/psh.hpp"
#include "harmonics/transform.hpp"

namespace nicol {

/// Expands a scalar field into the matrix that multiplies by it (Eq. 54), from integrals of triple products
/// that are computed once. Exact for a scalar field of order scalar_order; order_out + order_in is all that
/// can count.
class ShadowMatrix {
public:
    /// Throws Error(invalid_argument) for orders outside 0..CoefficientMatrix::kMaxDenseOrder (scalar: twice
    /// that).
    ShadowMatrix(int scalar_order, int order_out, int order_in);

    /// scalar: psh_count(scalar_order) coefficients over real harmonics. The result has only 0-0 and 2-2
    /// blocks.
    [[nodiscard]] CoefficientMatrix expand(std::span<const double> scalar) const;

private:
    struct Run {
        int first = 0;           // lowest order of the scalar field
        std::size_t offset = 0;  // into spin0_ and spin2_
        int count = 0;
    };

    int scalar_order_;
    int order_out_;
    int order_in_;
    std::vector<Run> runs_;  // by (l_out, m_out), (l_in, m_in)
    std::vector<double> spin0_;
    std::vector<double> spin2_;
};

/// The product itself through a grid, exact when the orders are those of the factors: O(L^3), no matrix.
/// Holds its work space; not for use by two threads at once.
class PshProduct {
public:
    /// The product's coefficients up to order_out; what lies above is cut. Throws Error(invalid_argument) for
    /// an order out of range.
    PshProduct(int scalar_order, int field_order, int order_out);

    /// scalar: psh_count(scalar_order) coefficients over real harmonics; field and out: one channel.
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
