// SPDX-License-Identifier: MIT
// Products with mirrored visibility as a matrix a vertex.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "simd/lanes.hpp"
#include "visibility/triple_product_tensor.hpp"

namespace nicol {

/// The shadow matrix (Eq. 54) of mirrored visibility falls into three symmetric blocks over LightLayout: even
/// to even, odd to odd, and one of spin harmonics that serves e and o. Sixteen vertices at once.
class ShadowMatrices {
public:
    /// Light that is multiplied at once.
    static constexpr std::size_t kMostChannels = 3;

    explicit ShadowMatrices(const LightLayout& layout);

    /// Numbers of one vertex: each element of the blocks once.
    [[nodiscard]] std::size_t size() const noexcept;
    /// From coefficients by psh_index, of twice the light's order.
    void make(const Lanes* visibility, Lanes* numbers) const;

    /// out[c] = matrix in[c] for the lights of at most kMostChannels channels. Numbers are multiples of
    /// 1 / kFixedOne, in pairs: [two numbers][lane][either].
    void multiply(const std::int16_t* numbers, std::span<const Lanes* const> in,
                  std::span<Lanes* const> out) const;

    /// A block of the matrix, which multiplies one or two parts of a light: where they begin.
    struct Block {
        TripleProductTensor triples;
        std::array<std::size_t, 2> begin;
        std::size_t parts;
    };
    /// Their numbers, each block's in the sequence of shadow_elements(), follow one another.
    [[nodiscard]] const std::array<Block, 3>& blocks() const noexcept { return blocks_; }

private:
    std::array<Block, 3> blocks_;
};

}  // namespace nicol
