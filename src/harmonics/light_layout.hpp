// SPDX-License-Identifier: MIT
// Layout of a light's coefficients in response tables and at vertices.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "harmonics/psh.hpp"

namespace nicol {

/// Stokes components that a light has; each level contains the levels before it.
enum class LightKind : std::int32_t { unpolarized = 1, linear = 3, full = 4 };

/// Layout of a light in the frame of a surface. The light is stored as real numbers, which are its
/// coefficients over an orthonormal basis that two mirrors split into halves.
///
/// The mirror in the plane of the surface, z -> -z, commutes with the product with a visibility that is equal
/// above and below the plane, so functions that the mirror keeps and functions that it negates never mix. For
/// s0 and s3, the two groups are the real harmonics of even and of odd l + m. The spin-2 part is e + i o,
/// both kept by the mirror, over the harmonics, for l >= 2,
///     m > 0: (2Y_lm + (-1)^l 2Y_l,-m) / sqrt 2        m < 0: -i (2Y_l|m| - (-1)^l 2Y_l,-|m|) / sqrt 2
///     m = 0: 2Y_l0 for even l, -i 2Y_l0 for odd l
/// with real coefficients; one real matrix multiplies both e and o. A light is
///     [s0 of even l + m, s0 of odd l + m, e, o, s3 of even l + m, s3 of odd l + m], as far as its kind has
///     them.
///
/// The mirror through the normal, phi -> -phi, keeps the even numbers and negates the odd numbers. Even
/// numbers are the cosines (m > 0) of s0 and e and the sines (m < 0) of o and s3. Numbers come in pairs: an
/// even and an odd number of equal l and |m|. For a viewer at azimuth phi, pairs of s0 and e, and with the
/// other sign of phi pairs of o and s3, become
///     even' = even cos m phi + odd sin m phi        odd' = odd cos m phi - even sin m phi.
/// A row of a response has one number for each pair and pairing. The first pairing gives s0 and s1 from the
/// even numbers, and s2 and s3 from the odd numbers; mirror-symmetric materials have no other. Other
/// isotropic materials also have the second pairing: s0 and s1 from the odd numbers, s2 and s3 from the even
/// numbers.
class LightLayout {
public:
    /// Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
    LightLayout(int order, LightKind kind);

    [[nodiscard]] int order() const noexcept { return order_; }
    [[nodiscard]] LightKind kind() const noexcept { return kind_; }
    /// Returns how many numbers a light has.
    [[nodiscard]] std::size_t size() const noexcept { return terms_.size(); }
    /// Returns how many pairs a light has, which is the length of a row in one pairing.
    [[nodiscard]] std::size_t row_size() const noexcept { return row_size_; }

    /// Consecutive pairs of one |m|, with l, l + step, ...
    struct Run {
        LightKind part;  ///< unpolarized: s0, linear: (s1, s2), full: s3
        int m;           ///< >= 0
        int l;
        int step;
        std::size_t count;
        /// Indices of the first even and the first odd number in a light. For m = 0 a pair has one number of
        /// e and one of o. s0 has no odd numbers at m = 0 and s3 no even numbers, so both indices are then
        /// equal, and rows have zeros.
        std::size_t even;
        std::size_t odd;
        float sign;  ///< sign of phi: 1 for s0 and e, -1 for o and s3
    };
    /// Returns the runs by m. The pairs of all runs in sequence are the pairs of a row.
    [[nodiscard]] const std::vector<Run>& runs() const noexcept { return runs_; }

    struct Harmonic {
        int l;
        int m;
    };
    /// Returns the harmonics of each group: for each |m| first m = |m| by l, then m = -|m|.
    [[nodiscard]] const std::vector<Harmonic>& even() const noexcept { return even_; }
    [[nodiscard]] const std::vector<Harmonic>& odd() const noexcept { return odd_; }
    [[nodiscard]] const std::vector<Harmonic>& spin() const noexcept { return spin_; }
    [[nodiscard]] std::size_t spin_begin() const noexcept { return even_.size() + odd_.size(); }
    [[nodiscard]] std::size_t s3_begin() const noexcept { return spin_begin() + 2 * spin_.size(); }

    /// Term of a number. A number is the sum of two terms, each a factor times the coefficient at index 4
    /// psh_index(l, m) + p; the second factor may be 0. With equal factors, a coefficient is a sum over
    /// numbers.
    struct Term {
        std::size_t coefficient;
        double factor;
    };
    [[nodiscard]] const std::vector<std::array<Term, 2>>& terms() const noexcept { return terms_; }

private:
    void add_scalar_terms(std::size_t p);
    void add_spin_terms(bool times_i);
    void add_runs(int m, std::size_t& even, std::size_t& odd, std::size_t& spin);

    int order_;
    LightKind kind_;
    std::vector<Harmonic> even_;
    std::vector<Harmonic> odd_;
    std::vector<Harmonic> spin_;
    std::vector<std::array<Term, 2>> terms_;
    std::vector<Run> runs_;
    std::size_t row_size_ = 0;
};

/// Computes the functions of the zenith angle for the pairs of a row from the harmonics 0Y_lm and 2Y_lm at
/// phi = 0, indexed by psh_index; spin2 may be empty if the layout is unpolarized. With c = cos m phi and s =
/// sin m phi, the even and the odd function of a pair are
///     s0: s0 = first c, s0 = first s                 s3: s3 = first s, s3 = first c
///     e and o: (s1, s2) = (first c, second s), sign (first s, -second c).
void zenith_functions(const LightLayout& layout, std::span<const double> scalar,
                      std::span<const double> spin2, std::span<double> first, std::span<double> second);

}  // namespace nicol
