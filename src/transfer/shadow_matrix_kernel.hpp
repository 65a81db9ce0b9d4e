// SPDX-License-Identifier: MIT
// Sixteen matrices times several vectors each.
#pragma once

#include <cstddef>
#include <cstdint>

#include "transfer/lanes.hpp"

namespace nicol {

/// Rows of a matrix that are kept side by side.
inline constexpr std::size_t kShadowTile = 4;

/// out[r] = matrix in[r] for `count` vectors. The matrices of sixteen vertices are interleaved:
/// [tile of kShadowTile rows][column][row of the tile][lane], fewer rows in the last tile. Numbers of 16 bits
/// are those of lane_vector.hpp.
void multiply_shadows(const float* matrix, std::size_t rows, std::size_t columns, const Lanes* const* in,
                      Lanes* const* out, std::size_t count);
void multiply_shadows(const std::int16_t* matrix, std::size_t rows, std::size_t columns,
                      const Lanes* const* in, Lanes* const* out, std::size_t count);

}  // namespace nicol
