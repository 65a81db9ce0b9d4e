// SPDX-License-Identifier: MIT
#include "visibility/shadow_matrices.hpp"

#include <algorithm>

#include "simd/zero_lanes.hpp"
#include "visibility/shadow_matrix_lanes.hpp"

namespace nicol {

using Group = TripleProductTensor::Group;

ShadowMatrices::ShadowMatrices(const LightLayout& layout)
    : blocks_{Block{{Group::even, layout, 2 * layout.order()},
                    {0, layout.s3_begin()},
                    layout.kind() == LightKind::full ? 2U : 1U},
              Block{{Group::odd, layout, 2 * layout.order()},
                    {layout.even().size(), layout.s3_begin() + layout.even().size()},
                    layout.kind() == LightKind::full ? 2U : 1U},
              Block{{Group::spin, layout, 2 * layout.order()},
                    {layout.spin_begin(), layout.spin_begin() + layout.spin().size()},
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
        const std::size_t size = block.triples.size();
        std::size_t count = 0;
        for (std::size_t c = 0; c < in.size(); ++c) {
            for (std::size_t part = 0; part < block.parts; ++part) {
                from[count] = in[c] + block.begin[part];
                to[count] = out[c] + block.begin[part];
                // Unpolarized light has zeros where its bounces are polarized.
                if (all_zero(std::span(from[count], size)))
                    std::fill_n(to[count], size, Lanes{});
                else
                    ++count;
            }
        }
        if (count > 0) multiply_shadows(numbers, size, from.data(), to.data(), count);
        numbers += block.triples.elements() * kLanes;
    }
}

}  // namespace nicol
