// SPDX-License-Identifier: MIT
#include "visibility/shadow_matrix_lanes.hpp"

#include <algorithm>

#include "simd/dispatch.hpp"
#include "simd/lane_vector.hpp"

namespace nicol {
namespace {

// Multiplies Count vectors by the rows of one tile and by their mirror image, the columns. Each number is
// loaded once for all vectors. Results of the tile's own rows become final; results of later rows are added
// to in memory. Returns the end of the tile's numbers.
template <std::size_t Rows, std::size_t Count>
[[gnu::always_inline]] inline const std::int16_t* multiply_tile(const std::int16_t* matrix, std::size_t size,
                                                                const Lanes* const* in, Lanes* const* out,
                                                                std::size_t row) {
    LaneVector sum[Rows][Count];
    LaneVector own[Rows][Count];
    // These copies keep the pointers in registers, because no store can change them.
    const Lanes* from[Count];
    Lanes* to[Count];
    for (std::size_t n = 0; n < Count; ++n) {
        from[n] = in[n];
        to[n] = out[n];
    }
    for (std::size_t n = 0; n < Count; ++n) {
        for (std::size_t r = 0; r < Rows; ++r) {
            load(to[n] + row + r, sum[r][n]);
            load(from[n] + row + r, own[r][n]);
        }
    }
    // An odd number of elements is padded by one that is ignored.
    LaneVector k[kShadowTile];
    std::size_t element = 0;
#pragma GCC unroll 4
    for (std::size_t c = 0; c < Rows; ++c) {
#pragma GCC unroll 4
        for (std::size_t r = 0; r <= c; ++r, ++element) {
            if (element % 2 == 0) {
                load_pair(matrix, k[0], k[1]);
                matrix += 2 * kLanes;
            }
            for (std::size_t n = 0; n < Count; ++n) {
                sum[r][n] += k[element % 2] * own[c][n];
                if (r != c) sum[c][n] += k[element % 2] * own[r][n];
            }
        }
    }
    // Only the last tile has fewer rows; it has no columns beyond them.
    for (std::size_t c = row + Rows; Rows == kShadowTile && c < size; ++c, matrix += Rows * kLanes) {
        load_pair(matrix, k[0], k[1]);
        load_pair(matrix + 2 * kLanes, k[2], k[3]);
        for (std::size_t n = 0; n < Count; ++n) {
            LaneVector x;
            LaneVector beyond;
            load(from[n] + c, x);
            load(to[n] + c, beyond);
            for (std::size_t r = 0; r < Rows; ++r) {
                sum[r][n] += k[r] * x;
                beyond += k[r] * own[r][n];
            }
            store(to[n] + c, beyond);
        }
    }
    for (std::size_t n = 0; n < Count; ++n) {
        for (std::size_t r = 0; r < Rows; ++r) store(to[n] + row + r, sum[r][n] * (1 / kPairedOne));
    }
    return matrix;
}

template <std::size_t Count>
[[gnu::always_inline]] inline void multiply_all(const std::int16_t* matrix, std::size_t size,
                                                const Lanes* const* in, Lanes* const* out) {
    for (std::size_t n = 0; n < Count; ++n) std::fill_n(out[n], size, Lanes{});
    std::size_t row = 0;
    for (; row + kShadowTile <= size; row += kShadowTile) {
        matrix = multiply_tile<kShadowTile, Count>(matrix, size, in, out, row);
    }
    static_assert(kShadowTile == 4);
    if (size - row == 3) multiply_tile<3, Count>(matrix, size, in, out, row);
    if (size - row == 2) multiply_tile<2, Count>(matrix, size, in, out, row);
    if (size - row == 1) multiply_tile<1, Count>(matrix, size, in, out, row);
}

[[gnu::always_inline]] inline void multiply_vectors(const std::int16_t* matrix, std::size_t size,
                                                    const Lanes* const* in, Lanes* const* out,
                                                    std::size_t count) {
    // The number of vectors at once is limited by the registers.
    for (std::size_t n = 0; n < count;) {
        const std::size_t left = count - n;
        if (left >= 3) {
            multiply_all<3>(matrix, size, in + n, out + n);
            n += 3;
        } else if (left == 2) {
            multiply_all<2>(matrix, size, in + n, out + n);
            n += 2;
        } else {
            multiply_all<1>(matrix, size, in + n, out + n);
            n += 1;
        }
    }
}

}  // namespace

std::vector<ShadowElement> shadow_elements(std::size_t size) {
    std::vector<ShadowElement> elements;
    for (std::size_t row = 0; row < size; row += kShadowTile) {
        for (std::size_t column = row; column < size; ++column) {
            const std::size_t end = std::min(row + kShadowTile, column + 1);
            for (std::size_t r = row; r < end; ++r) elements.push_back({r, column});
        }
    }
    if (elements.size() % 2 != 0) elements.push_back(elements.back());
    return elements;
}

void multiply_shadows(const std::int16_t* matrix, std::size_t size, const Lanes* const* in, Lanes* const* out,
                      std::size_t count) {
    dispatch<multiply_vectors>(matrix, size, in, out, count);
}

}  // namespace nicol
