// SPDX-License-Identifier: MIT
// Light split into parts that the mirror in the plane of the surface keeps and turns round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// A field f as even(f) + odd(f): z -> -z keeps the one and negates the other. A product with visibility that
/// is the same above and below keeps both apart. Of s0 and s3 they are the harmonics of even and odd l + m.
/// The spin-2 part splits as e + i o with both e and o even; the harmonics of either are, for l >= 2,
///   m > 0: (2Y_lm + (-1)^l 2Y_l,-m) / sqrt 2        m < 0: i (2Y_l|m| - (-1)^l 2Y_l,-|m|) / sqrt 2
///   m = 0: 2Y_l0 for even l, i 2Y_l0 for odd l
/// with real coefficients, orthonormal over the real inner product of (s1, s2). The same real matrix
/// therefore multiplies e and o.
class MirrorBasis {
public:
    struct Harmonic {
        int l;
        int m;
    };

    explicit MirrorBasis(const LightLayout& layout);

    /// Harmonics of each group, for each |m| first those of m = |m| by l, then those of m = -|m|.
    [[nodiscard]] const std::vector<Harmonic>& even() const noexcept { return even_; }
    [[nodiscard]] const std::vector<Harmonic>& odd() const noexcept { return odd_; }
    [[nodiscard]] const std::vector<Harmonic>& spin() const noexcept { return spin_; }

    /// A split light is [s0 even, s0 odd, e, o, s3 even, s3 odd], as far as the kind has them.
    [[nodiscard]] std::size_t size() const noexcept { return size_; }
    [[nodiscard]] std::size_t spin_begin() const noexcept { return even_.size() + odd_.size(); }
    [[nodiscard]] std::size_t s3_begin() const noexcept { return spin_begin() + 2 * spin_.size(); }
    [[nodiscard]] LightKind kind() const noexcept { return kind_; }
    /// Numbers of a packed light: real, then imaginary parts.
    [[nodiscard]] std::size_t packed_size() const noexcept { return packed_size_; }

    /// From a packed light and back; the numbers must not overlap.
    void split(const Lanes* packed, Lanes* out) const;
    void join(const Lanes* in, Lanes* packed) const;
    void split(const float* packed, float* out) const;
    void join(const float* in, float* packed) const;

    /// The coefficients of (l, m) and (l, -m) of s0, m >= 0; those of s3 are s3_begin() further.
    struct ScalarPair {
        int m;
        std::size_t cosine;  ///< where a split light has them
        std::size_t sine;    ///< of m = 0: there is none, and this equals cosine
        std::size_t entry;   ///< of the layout; of s3, s3_entry() further
    };
    /// The coefficients of (l, m) and (l, -m) of e, m >= 0; those of o are spin().size() further.
    struct SpinPair {
        int l;
        int m;
        std::size_t cosine;
        std::size_t sine;   ///< of m = 0: there is none, and this equals cosine
        std::size_t plus;   ///< entry of the layout of (l, m)
        std::size_t minus;  ///< and of (l, -m)
    };
    /// Both by ascending m.
    [[nodiscard]] const std::vector<ScalarPair>& scalar_pairs() const noexcept { return scalars_; }
    [[nodiscard]] const std::vector<SpinPair>& spin_pairs() const noexcept { return spins_; }
    [[nodiscard]] std::size_t s3_entry() const noexcept { return s3_entry_; }

private:
    void add_scalars(const LightLayout& layout);
    void add_spins(const LightLayout& layout);
    template <class Number>
    void split_scalars(const Number* first, const Number* second, Number* out) const;
    template <class Number>
    void join_scalars(const Number* in, Number* first, Number* second) const;
    template <class Number>
    void split_numbers(const Number* packed, Number* out) const;
    template <class Number>
    void join_numbers(const Number* in, Number* packed) const;

    LightKind kind_;
    std::vector<Harmonic> even_;
    std::vector<Harmonic> odd_;
    std::vector<Harmonic> spin_;
    std::size_t size_;
    std::size_t packed_size_;
    std::size_t s3_entry_ = 0;
    std::vector<ScalarPair> scalars_;
    std::vector<SpinPair> spins_;
};

}  // namespace nicol
