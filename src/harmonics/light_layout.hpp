// SPDX-License-Identifier: MIT
// How light and response are laid out for their dot product.
#pragma once

#include <complex>
#include <cstdint>
#include <span>
#include <vector>

#include "harmonics/psh.hpp"

namespace nicol {

/// Which Stokes components a light has; each level contains the ones before.
enum class LightKind : std::int32_t { unpolarized = 1, linear = 3, full = 4 };

/// PSH coefficients of one light as complex numbers z_j, ordered so that
/// - a turn of the viewer's azimuth by phi is z_j *= exp(i k_j phi), nothing else, and
/// - a mirror-symmetric material needs only the real parts to make s0 and s1, and only the imaginary parts to
/// make s2
///   and s3: half of all products vanish by construction.
/// s0: a_lm + i a_l,-m for m >= 0, k = -m. (s1, s2): the spin-2 coefficients for all m, l >= 2, k = m.
/// s3: a_l,-m + i a_lm for m >= 0, k = m. a are the coefficients over real harmonics; the imaginary (s0) or
/// real (s3) part that m = 0 does not have is zero.
class LightLayout {
public:
    struct Entry {
        LightKind part;  ///< unpolarized: s0, linear: (s1, s2), full: s3
        int l;
        int m;
        [[nodiscard]] int azimuthal_frequency() const noexcept {
            return part == LightKind::unpolarized ? -m : m;
        }
    };

    /// Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
    LightLayout(int order, LightKind kind);

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] LightKind kind() const noexcept { return kind_; }
    [[nodiscard]] std::size_t size() const noexcept { return entries_.size(); }
    [[nodiscard]] const std::vector<Entry>& entries() const noexcept { return entries_; }

    /// From the coefficients of one channel, [psh_index(l, m)][4], of at least this order.
    [[nodiscard]] std::vector<std::complex<double>> pack(std::span<const double> channel) const;

private:
    int order_;
    LightKind kind_;
    std::vector<Entry> entries_;
};

}  // namespace nicol
