// SPDX-License-Identifier: MIT
// Product of sixteen symmetric matrices and several vectors each.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "simd/lanes.hpp"

namespace nicol {

/// Number of rows of a matrix that are read together.
inline constexpr std::size_t kShadowTile = 4;

/// An element of a symmetric matrix, row <= column.
struct ShadowElement {
    std::size_t row;
    std::size_t column;
};
/// Returns the elements of a matrix of `size` rows in storage order: by tiles of kShadowTile rows, within a
/// tile by columns, then rows. The count is even; the last element may be repeated.
[[nodiscard]] std::vector<ShadowElement> shadow_elements(std::size_t size);

/// Computes out[n] = matrix in[n] for `count` vectors. The shadow_elements() of sixteen vertices are
/// interleaved by pairs, [pair of elements][lane][element of the pair], in multiples of 1 / kFixedOne.
void multiply_shadows(const std::int16_t* matrix, std::size_t size, const Lanes* const* in, Lanes* const* out,
                      std::size_t count);

}  // namespace nicol
