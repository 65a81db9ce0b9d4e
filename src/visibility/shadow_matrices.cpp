// SPDX-License-Identifier: MIT
#include "visibility/shadow_matrices.hpp"

#include <algorithm>

#include "visibility/shadow_matrix_kernel.hpp"

namespace nicol {

using Group = TripleProductTensor::Group;

ShadowMatrices::ShadowMatrices(const MirrorBasis& basis, int visibility_order)
    : blocks_{Block{{Group::even, basis, visibility_order},
                    {0, basis.s3_begin()},
                    basis.kind() == LightKind::full ? 2U : 1U},
              Block{{Group::odd, basis, visibility_order},
                    {basis.even().size(), basis.s3_begin() + basis.even().size()},
                    basis.kind() == LightKind::full ? 2U : 1U},
              Block{{Group::spin, basis, visibility_order},
                    {basis.spin_begin(), basis.spin_begin() + basis.spin().size()},
                    2U}} {}

std::size_t ShadowMatrices::size() const noexcept {
    std::size_t size = 0;
    for (const Block& block : blocks_) size += block.triples.elements();
    return size;
}

void ShadowMatrices::make(const Lanes* visibility, Lanes* numbers) const {
    for (const Block& block : blocks_) {
        block.triples.make(visibility, numbers);
        numbers += block.triples.elements();
    }
}

void ShadowMatrices::multiply(const std::int16_t* numbers, std::span<const Lanes* const> in,
                              std::span<Lanes* const> out) const {
    for (const Block& block : blocks_) {
        std::array<const Lanes*, 2 * kMostChannels> from{};
        std::array<Lanes*, 2 * kMostChannels> to{};
        std::size_t count = 0;
        for (std::size_t c = 0; c < in.size(); ++c) {
            for (std::size_t part = 0; part < block.parts; ++part, ++count) {
                from[count] = in[c] + block.begin[part];
                to[count] = out[c] + block.begin[part];
            }
        }
        multiply_shadows(numbers, block.triples.size(), from.data(), to.data(), count);
        numbers += block.triples.elements() * kLanes;
    }
}

std::vector<std::size_t> ShadowMatrices::whole() const {
    std::vector<std::size_t> places;
    std::size_t number = 0;
    for (const Block& block : blocks_) {
        const std::size_t size = block.triples.size();
        std::vector<std::size_t> position(size * size);
        for (const auto& [row, column] : shadow_elements(size)) {
            position[row * size + column] = position[column * size + row] = number++;
        }
        for (std::size_t first = 0; first < size; first += kShadowTile) {
            for (std::size_t column = 0; column < size; ++column) {
                for (std::size_t row = first; row < std::min(first + kShadowTile, size); ++row) {
                    places.push_back(position[row * size + column]);
                }
            }
        }
    }
    return places;
}

}  // namespace nicol
