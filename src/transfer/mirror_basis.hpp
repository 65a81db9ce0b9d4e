// SPDX-License-Identifier: MIT
// Light split into parts that the mirror in the plane of the surface keeps and turns round.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "nicol/light_layout.hpp"
#include "transfer/lanes.hpp"

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

    /// From a packed light and back; the lanes must not overlap.
    void split(const Lanes* packed, Lanes* out) const;
    void join(const Lanes* in, Lanes* packed) const;

private:
    struct Scalar {
        std::size_t packed;
        std::size_t split;
    };
    // The four numbers of (l, m) and (l, -m), or the two of (l, 0).
    struct Spin {
        std::size_t plus;    // of (l, m) in the packed light; the imaginary part is half its size further
        std::size_t minus;   // of (l, -m)
        std::size_t cosine;  // of (l, m) in e; in o it is spin().size() further
        std::size_t sine;    // of (l, -m)
        bool zonal;
        bool odd;  // l
    };

    void add_scalars(const LightLayout& layout, LightKind part, std::size_t first);
    void add_spins(const LightLayout& layout);

    LightKind kind_;
    std::vector<Harmonic> even_;
    std::vector<Harmonic> odd_;
    std::vector<Harmonic> spin_;
    std::size_t size_;
    std::size_t packed_size_;
    std::vector<Scalar> scalars_;
    std::vector<Spin> spins_;
    std::vector<std::size_t> zeros_;  // in a packed light
};

}  // namespace nicol
