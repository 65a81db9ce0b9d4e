// SPDX-License-Identifier: MIT
// Products with mirrored visibility as a matrix a vertex.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "harmonics/mirror_basis.hpp"
#include "simd/lanes.hpp"
#include "visibility/triple_product_tensor.hpp"

namespace nicol {

/// The shadow matrix (Eq. 54) of mirrored visibility falls into three symmetric blocks over MirrorBasis: even
/// to even, odd to odd, and one of spin harmonics that serves e and o. Sixteen vertices at once.
class ShadowMatrices {
public:
    /// Light that is multiplied at once.
    static constexpr std::size_t kMostChannels = 3;

    explicit ShadowMatrices(const MirrorBasis& basis, int visibility_order);

    /// Numbers of one vertex: each element of the blocks once.
    [[nodiscard]] std::size_t size() const noexcept;
    /// From coefficients by psh_index, of the visibility's order.
    void make(const Lanes* visibility, Lanes* numbers) const;

    /// out[c] = matrix in[c] for the split lights of at most kMostChannels channels. Numbers are multiples of
    /// 1 / kFixedOne, in pairs: [two numbers][lane][either].
    void multiply(const std::int16_t* numbers, std::span<const Lanes* const> in,
                  std::span<Lanes* const> out) const;

    /// Which of one vertex's numbers stands where in whole blocks, one after another: tiles of kShadowTile
    /// rows, in them column after column.
    [[nodiscard]] std::vector<std::size_t> whole() const;

private:
    // A block of the matrix and where the two parts of a light begin that it multiplies.
    struct Block {
        TripleProductTensor triples;
        std::array<std::size_t, 2> begin;
        std::size_t parts;
    };

    std::array<Block, 3> blocks_;
};

}  // namespace nicol
