// SPDX-License-Identifier: MIT
// Product of light and mirrored visibility as one matrix per vertex.
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

/// The shadow matrix (Eq. 54) of mirrored visibility, for sixteen vertices at once. It consists of three
/// symmetric blocks over LightLayout: even to even, odd to odd, and one block of spin harmonics that serves
/// both e and o.
class ShadowMatrices {
public:
    /// Largest number of channels that are multiplied at once.
    static constexpr std::size_t kMostChannels = 3;

    explicit ShadowMatrices(const LightLayout& layout);

    /// Returns the count of numbers per vertex: each element of the blocks once.
    [[nodiscard]] std::size_t size() const noexcept;
    /// Computes the numbers from coefficients of visibility by psh_index, of twice the light's order.
    void make(const Lanes* visibility, Lanes* numbers) const;

    /// Computes out[c] = matrix in[c] for the lights of at most kMostChannels channels. Numbers are multiples
    /// of 1 / kFixedOne, in pairs: [pair of numbers][lane][number of the pair].
    void multiply(const std::int16_t* numbers, std::span<const Lanes* const> in,
                  std::span<Lanes* const> out) const;

    /// A block of the matrix and the one or two parts of a light that it multiplies, by their first
    /// coefficient.
    struct Block {
        TripleProductTensor triples;
        std::array<std::size_t, 2> begin;
        std::size_t parts;
    };
    /// Returns the blocks. Their numbers follow one another, each block's in the order of shadow_elements().
    [[nodiscard]] const std::array<Block, 3>& blocks() const noexcept { return blocks_; }

private:
    std::array<Block, 3> blocks_;
};

}  // namespace nicol
