// SPDX-License-Identifier: MIT
#include "transfer/shadow_matrices.hpp"

#include <algorithm>
#include <vector>

#include "transfer/shadow_matrix_kernel.hpp"

namespace nicol {

using Group = ShadowTriples::Group;

ShadowMatrices::ShadowMatrices(int order_in, const MirrorBasis& in, int order_out, const MirrorBasis& out)
    : blocks_{Block{{Group::even, out, in, order_in + order_out},
                    {0, in.s3_begin()},
                    {0, out.s3_begin()},
                    in.kind() == LightKind::full ? 2U : 1U},
              Block{{Group::odd, out, in, order_in + order_out},
                    {in.even().size(), in.s3_begin() + in.even().size()},
                    {out.even().size(), out.s3_begin() + out.even().size()},
                    in.kind() == LightKind::full ? 2U : 1U},
              Block{{Group::spin, out, in, order_in + order_out},
                    {in.spin_begin(), in.spin_begin() + in.spin().size()},
                    {out.spin_begin(), out.spin_begin() + out.spin().size()},
                    2U}} {}

std::size_t ShadowMatrices::size() const noexcept {
    std::size_t size = 0;
    for (const Block& block : blocks_) size += block.triples.rows() * block.triples.columns();
    return size;
}

void ShadowMatrices::make(const Lanes* visibility, Lanes* numbers) const {
    std::vector<Lanes> matrix;
    for (const Block& block : blocks_) {
        const std::size_t rows = block.triples.rows();
        const std::size_t columns = block.triples.columns();
        matrix.resize(rows * columns);
        block.triples.expand(visibility, matrix.data());
        for (std::size_t first = 0; first < rows; first += kShadowTile) {
            const std::size_t last = std::min(first + kShadowTile, rows);
            for (std::size_t c = 0; c < columns; ++c) {
                for (std::size_t r = first; r < last; ++r) *numbers++ = matrix[r * columns + c];
            }
        }
    }
}

template <class Number>
void ShadowMatrices::multiply_blocks(const Number* numbers, std::span<const Lanes* const> in,
                                     std::span<Lanes* const> out) const {
    for (const Block& block : blocks_) {
        std::array<const Lanes*, 2 * kMostChannels> from{};
        std::array<Lanes*, 2 * kMostChannels> to{};
        std::size_t count = 0;
        for (std::size_t c = 0; c < in.size(); ++c) {
            for (std::size_t part = 0; part < block.parts; ++part, ++count) {
                from[count] = in[c] + block.in[part];
                to[count] = out[c] + block.out[part];
            }
        }
        const std::size_t rows = block.triples.rows();
        const std::size_t columns = block.triples.columns();
        multiply_shadows(numbers, rows, columns, from.data(), to.data(), count);
        numbers += rows * columns * kLanes;
    }
}

void ShadowMatrices::multiply(const float* numbers, std::span<const Lanes* const> in,
                              std::span<Lanes* const> out) const {
    multiply_blocks(numbers, in, out);
}

void ShadowMatrices::multiply(const std::int16_t* numbers, std::span<const Lanes* const> in,
                              std::span<Lanes* const> out) const {
    multiply_blocks(numbers, in, out);
}

}  // namespace nicol
