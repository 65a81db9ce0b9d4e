// SPDX-License-Identifier: MIT
// Rotation of Stokes vector fields that are given by coefficients.
#pragma once

#include <complex>
#include <span>
#include <vector>

#include <glm/mat3x3.hpp>

#include "harmonics/psh.hpp"

namespace nicol {

/// ZYZ Euler angles by the quantities that a rotation of harmonics needs. No angle is ever formed, so beta =
/// 0 and beta = pi lose nothing. R = Rz(alpha) Ry(beta) Rz(gamma).
struct EulerZyz {
    std::complex<double> alpha;  ///< exp(i alpha)
    std::complex<double> gamma;  ///< exp(i gamma)
    double sin_half_beta;
    double cos_half_beta;
};

/// Returns the Euler angles of a rotation. Throws Error(invalid_argument) unless `rotation` is orthonormal to
/// 1e-5 and right-handed. The remaining deviation is removed.
[[nodiscard]] EulerZyz euler_zyz(const glm::dmat3& rotation);

/// Rotation ready to be applied to many coefficient vectors: (R f)(w) = R_S f(R^-1 w) (Eqs. 25, 36).
class PshRotation {
public:
    /// Highest order whose matrices are stored. For higher orders each apply() computes the matrices again,
    /// so pass all vectors in one call.
    static constexpr int kStoredOrder = 64;

    /// Throws Error(invalid_argument) for an order out of range or a matrix that is no rotation.
    PshRotation(int order, const glm::dmat3& rotation);

    [[nodiscard]] int order() const noexcept { return order_; }

    /// Rotates vectors [vector][psh_index(l, m)][p] laid out one after another. `in` and `out` may be the
    /// same memory but must not overlap otherwise. Throws Error(invalid_argument) unless both have the same
    /// length, a multiple of 4 * psh_count(order()).
    void apply(std::span<const double> in, std::span<double> out) const;

private:
    int order_;
    EulerZyz euler_;
    std::vector<std::complex<double>> alpha_;  // exp(-i m alpha), m = 0..order
    std::vector<std::complex<double>> gamma_;
    std::vector<double> d_;
};

/// Returns the field with all channels rotated. Throws what PshRotation throws.
[[nodiscard]] PshVector rotated(const PshVector& field, const glm::dmat3& rotation);

}  // namespace nicol
