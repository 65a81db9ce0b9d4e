// SPDX-License-Identifier: MIT
// Linear operators on Stokes vector fields as coefficient matrices.
#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "harmonics/grid.hpp"
#include "harmonics/psh.hpp"
#include "polarization/mueller.hpp"

namespace nicol {

/// Dense matrix of any real-linear operator between coefficient vectors (Eq. 40).
class CoefficientMatrix {
public:
    CoefficientMatrix() = default;
    /// Makes a matrix of zeros. Throws Error(invalid_argument) unless both orders are within
    /// 0..kMaxDenseOrder.
    CoefficientMatrix(int order_out, int order_in);

    static constexpr int kMaxDenseOrder = 64;

    [[nodiscard]] int order_out() const noexcept { return order_out_; }
    [[nodiscard]] int order_in() const noexcept { return order_in_; }
    [[nodiscard]] std::size_t rows() const noexcept { return 4 * psh_count(order_out_); }
    [[nodiscard]] std::size_t columns() const noexcept { return 4 * psh_count(order_in_); }

    /// Returns the element between position 4 * psh_index(l, m) + p of the output and of the input; not
    /// range-checked.
    [[nodiscard]] double& operator()(std::size_t row, std::size_t column) {
        return data_[row * columns() + column];
    }
    [[nodiscard]] double operator()(std::size_t row, std::size_t column) const {
        return data_[row * columns() + column];
    }
    [[nodiscard]] std::span<double> data() noexcept { return data_; }
    [[nodiscard]] std::span<const double> data() const noexcept { return data_; }

    /// Computes out = matrix * in for one channel; the spans must not overlap.
    void apply(std::span<const double> in, std::span<double> out) const;

private:
    int order_out_ = -1;
    int order_in_ = -1;
    std::vector<double> data_;
};

/// Returns `second` after `first`. Throws Error(invalid_argument) unless the orders between them agree.
[[nodiscard]] CoefficientMatrix compose(const CoefficientMatrix& second, const CoefficientMatrix& first);

/// Operator that commutes with rotations about z, such as an isotropic pBRDF in the frame of its surface. The
/// operator keeps the degree (Eqs. 52, 53), so it consists of one complex 4 x 4 block for each (m >= 0,
/// l_out, l_in). A block acts on (s0_lm, s3_lm, w_lm, conj w_l-m): the coefficients of s0 and s3 over complex
/// harmonics, and w = s1 + i s2. The elements between spin 2 and spin 2 hold the isomorphic part P_lm,lm and
/// the conjugation part P_lm,l-m.
class IsotropicMatrix {
public:
    using Block = std::array<std::complex<double>, 16>;  ///< row-major

    IsotropicMatrix() = default;
    /// Makes a matrix of zeros. Throws Error(invalid_argument) for an order out of range.
    IsotropicMatrix(int order_out, int order_in);

    [[nodiscard]] int order_out() const noexcept { return order_out_; }
    [[nodiscard]] int order_in() const noexcept { return order_in_; }
    /// Returns the block for 0 <= m <= min(order_out, order_in), with l_out and l_in from m on; not
    /// range-checked.
    [[nodiscard]] Block& block(int m, int l_out, int l_in) { return blocks_[position(m, l_out, l_in)]; }
    [[nodiscard]] const Block& block(int m, int l_out, int l_in) const {
        return blocks_[position(m, l_out, l_in)];
    }

    /// Returns all blocks of one m, [l_out][l_in].
    [[nodiscard]] std::span<Block> blocks(int m) { return {&block(m, m, m), count(m)}; }
    [[nodiscard]] std::span<const Block> blocks(int m) const { return {&block(m, m, m), count(m)}; }

    /// Computes out = matrix * in for one channel; the spans must not overlap.
    void apply(std::span<const double> in, std::span<double> out) const;
    [[nodiscard]] CoefficientMatrix dense() const;

private:
    [[nodiscard]] std::size_t position(int m, int l_out, int l_in) const {
        return first_[static_cast<std::size_t>(m)] +
               static_cast<std::size_t>((l_out - m) * (order_in_ - m + 1) + l_in - m);
    }

    [[nodiscard]] std::size_t count(int m) const {
        return static_cast<std::size_t>(order_out_ - m + 1) * static_cast<std::size_t>(order_in_ - m + 1);
    }

    int order_out_ = -1;
    int order_in_ = -1;
    std::vector<std::size_t> first_;  // by m
    std::vector<Block> blocks_;
};

[[nodiscard]] IsotropicMatrix compose(const IsotropicMatrix& second, const IsotropicMatrix& first);

/// Mueller transform field (Eq. 38): the matrix from the theta-phi frame of the incoming propagation
/// direction to the theta-phi frame of the outgoing direction, cosine factors included.
using MuellerField = std::function<Mueller(const glm::dvec3& in, const glm::dvec3& out)>;

/// Directions at which a Mueller field is sampled.
struct SphereGrid {
    LatitudeRows rows;
    int columns = 0;
};

/// Returns the coefficient matrix by quadrature (Eq. 40); exact if the field is band-limited and the grids
/// resolve it. Throws Error(invalid_argument) for grids too coarse for the orders or a value that is not
/// finite.
[[nodiscard]] CoefficientMatrix project(const MuellerField& field, int order_out, const SphereGrid& out,
                                        int order_in, const SphereGrid& in);

/// Mueller field that depends on the azimuths only by their difference. Arguments: zenith angles of the
/// incoming and outgoing propagation directions, and phi = phi_in - phi_out. Frames are those of
/// MuellerField.
using IsotropicMuellerField = std::function<Mueller(double theta_in, double theta_out, double phi)>;

/// Projects an isotropic field, which is sampled at one outgoing azimuth only (out.columns = 1).
[[nodiscard]] IsotropicMatrix project_isotropic(const IsotropicMuellerField& field, int order_out,
                                                const LatitudeRows& out, int order_in, const SphereGrid& in);

/// Returns the mirror image in the plane z = 0 (supplement E.6): spin-2 coefficients become (-1)^l
/// conj(f_l,-m) (Eq. 214 with its conjugation), s0 gains (-1)^(l+m), and s3 gains -(-1)^(l+m), because a
/// mirror image rotates the other way round.
[[nodiscard]] PshVector reflected(const PshVector& field);
/// Returns reflected() as an operator.
[[nodiscard]] IsotropicMatrix reflection_matrix(int order);

/// Returns the factor that converts the square of a block's element to the sum of squares of the real matrix
/// entries for which the element stands. Lanes 0 to 3 are s0, s3, w, conj w. Summed over all elements the
/// result is the squared Frobenius norm.
[[nodiscard]] double block_weight(int m, std::size_t out, std::size_t in);

/// Returns the norm of the part that breaks the symmetry under mirror images in planes through the axis,
/// divided by the norm of the whole, 0 to 1; 0 for zero matrices.
[[nodiscard]] double asymmetry(const IsotropicMatrix& matrix);

/// Keeps only the part that has this mirror symmetry, which is the mean of the operator and its mirror image.
void symmetrize(IsotropicMatrix& matrix);

}  // namespace nicol
