// SPDX-License-Identifier: MIT
// Sixteen symmetric matrices times several vectors each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simd/lanes.hpp"

namespace nicol {

/// Rows of a matrix that are read together.
inline constexpr std::size_t kShadowTile = 4;

/// An element of a matrix, row <= column; that of column and row is the same.
struct ShadowElement {
    std::size_t row;
    std::size_t column;
};
/// The elements of a matrix of `size` rows in the sequence that their numbers are kept in: by tiles of
/// kShadowTile rows, in them by columns, then rows. An even count: the last may be there twice.
[[nodiscard]] std::vector<ShadowElement> shadow_elements(std::size_t size);

/// out[n] = matrix in[n] for `count` vectors. The shadow_elements() of sixteen vertices are interleaved by
/// pairs, [two elements][lane][either], in multiples of 1 / kFixedOne.
void multiply_shadows(const std::int16_t* matrix, std::size_t size, const Lanes* const* in, Lanes* const* out,
                      std::size_t count);

}  // namespace nicol
