// SPDX-License-Identifier: MIT
#include "transfer/shadow_matrix_kernel.hpp"

#include "transfer/lane_vector.hpp"
#include "transfer/simd.hpp"

namespace nicol {
namespace {

// Rows of one tile times Count vectors: each number of the matrix is loaded once for all of them.
template <std::size_t Rows, std::size_t Count, class Number>
[[gnu::always_inline]] inline void multiply_tile(const Number* matrix, std::size_t columns,
                                                 const Lanes* const* in, Lanes* const* out, std::size_t row,
                                                 float scale) {
    LaneVector sum[Rows][Count] = {};
    for (std::size_t c = 0; c < columns; ++c) {
        LaneVector k[Rows];
        for (std::size_t r = 0; r < Rows; ++r) load(matrix + (c * Rows + r) * kLanes, k[r]);
        for (std::size_t n = 0; n < Count; ++n) {
            LaneVector x;
            load(in[n] + c, x);
            for (std::size_t r = 0; r < Rows; ++r) sum[r][n] += k[r] * x;
        }
    }
    for (std::size_t n = 0; n < Count; ++n) {
        for (std::size_t r = 0; r < Rows; ++r) {
            store(out[n] + row + r, sum[r][n] * scale);
        }
    }
}

template <std::size_t Count, class Number>
[[gnu::always_inline]] inline void multiply_all(const Number* matrix, std::size_t rows, std::size_t columns,
                                                const Lanes* const* in, Lanes* const* out, float scale) {
    std::size_t row = 0;
    for (; row + kShadowTile <= rows; row += kShadowTile) {
        multiply_tile<kShadowTile, Count>(matrix + row * columns * kLanes, columns, in, out, row, scale);
    }
    const Number* rest = matrix + row * columns * kLanes;
    static_assert(kShadowTile == 4);
    if (rows - row == 3) multiply_tile<3, Count>(rest, columns, in, out, row, scale);
    if (rows - row == 2) multiply_tile<2, Count>(rest, columns, in, out, row, scale);
    if (rows - row == 1) multiply_tile<1, Count>(rest, columns, in, out, row, scale);
}

// As many vectors at once as there are, six at most.
template <class Number>
[[gnu::always_inline]] inline void multiply_groups(const Number* matrix, std::size_t rows,
                                                   std::size_t columns, const Lanes* const* in,
                                                   Lanes* const* out, std::size_t count, float scale) {
    for (std::size_t n = 0; n < count;) {
        const std::size_t left = count - n;
        if (left >= 6) {
            multiply_all<6>(matrix, rows, columns, in + n, out + n, scale);
            n += 6;
        } else if (left >= 3) {
            multiply_all<3>(matrix, rows, columns, in + n, out + n, scale);
            n += 3;
        } else if (left == 2) {
            multiply_all<2>(matrix, rows, columns, in + n, out + n, scale);
            n += 2;
        } else {
            multiply_all<1>(matrix, rows, columns, in + n, out + n, scale);
            n += 1;
        }
    }
}

NICOL_MULTIVERSION
void multiply_floats(const float* matrix, std::size_t rows, std::size_t columns, const Lanes* const* in,
                     Lanes* const* out, std::size_t count) {
    multiply_groups(matrix, rows, columns, in, out, count, 1.0F);
}

NICOL_MULTIVERSION
void multiply_fixed(const std::int16_t* matrix, std::size_t rows, std::size_t columns, const Lanes* const* in,
                    Lanes* const* out, std::size_t count) {
    multiply_groups(matrix, rows, columns, in, out, count, 1.0F / kFixedOne);
}

}  // namespace

void multiply_shadows(const float* matrix, std::size_t rows, std::size_t columns, const Lanes* const* in,
                      Lanes* const* out, std::size_t count) {
    multiply_floats(matrix, rows, columns, in, out, count);
}

void multiply_shadows(const std::int16_t* matrix, std::size_t rows, std::size_t columns,
                      const Lanes* const* in, Lanes* const* out, std::size_t count) {
    multiply_fixed(matrix, rows, columns, in, out, count);
}

}  // namespace nicol
