// SPDX-License-Identifier: MIT
// Coefficients of polarized spherical harmonics (PSH, Eqs. 29 to 34).
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace nicol {

/// Highest order that any function of the library accepts.
inline constexpr int kMaxOrder = 4096;

/// Returns the position of (l, m) in a coefficient vector: l*l + l + m.
[[nodiscard]] constexpr std::size_t psh_index(int l, int m) {
    return static_cast<std::size_t>(l * l + l + m);
}

/// Returns the number of (l, m) pairs for orders 0..order.
[[nodiscard]] constexpr std::size_t psh_count(int order) {
    return static_cast<std::size_t>(order + 1) * static_cast<std::size_t>(order + 1);
}

/// Stokes vector field as coefficients [channel][psh_index(l, m)][p], p = 0..3. p = 0, 3 are over real
/// harmonics; p = 1, 2 are the real and imaginary part of the complex spin-2 coefficient and are zero below l
/// = 2. The field is a function of the PROPAGATION direction of the light. Its components are in the
/// theta-phi frame.
class PshVector {
public:
    PshVector() = default;
    /// Makes a field of zeros. Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder and channels >=
    /// 1.
    PshVector(int order, int channels);

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] int channels() const noexcept { return channels_; }
    /// Returns the coefficients of one channel, 4 * psh_count(order()) values.
    [[nodiscard]] std::span<double> channel(int c);
    [[nodiscard]] std::span<const double> channel(int c) const;
    [[nodiscard]] double& at(int c, int l, int m, int p);
    [[nodiscard]] double at(int c, int l, int m, int p) const;
    [[nodiscard]] std::span<double> data() noexcept { return data_; }
    [[nodiscard]] std::span<const double> data() const noexcept { return data_; }

private:
    int order_ = 0;
    int channels_ = 0;
    std::vector<double> data_;
};

/// Returns the field with orders up to `order`: higher orders are left out, and missing orders are zero.
/// Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
[[nodiscard]] PshVector with_order(const PshVector& field, int order);

/// Multiplies the coefficients of order l by gains[l], equally for all components so that degrees of
/// polarization survive. Throws Error(invalid_argument) unless there is a gain for each of the field's
/// orders.
void scale_orders(PshVector& field, std::span<const double> gains);

}  // namespace nicol
