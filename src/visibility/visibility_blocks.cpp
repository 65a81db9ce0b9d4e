// SPDX-License-Identifier: MIT
#include "visibility/visibility_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "harmonics/psh.hpp"

namespace nicol {

VisibilityBlocks::VisibilityBlocks(const Visibility& visibility, int order)
    : order_(order), vertices_(visibility.vertices()) {
    for (int m = 0; m <= order_; ++m) {
        for (int l = m; l <= order_; l += 2) {
            kept_.push_back(psh_index(l, m));
            if (m > 0) kept_.push_back(psh_index(l, -m));
        }
    }
    std::uint32_t count = 0;
    for (std::size_t begin = 0; begin < vertices_; begin += kLanes) {
        const auto block = visibility.unoccluded().subspan(begin, std::min(kLanes, vertices_ - begin));
        const bool shadowed = std::ranges::any_of(block, [](std::uint8_t v) { return v == 0; });
        place_.push_back(shadowed ? count++ : kUnoccluded);
    }
    numbers_.resize(count * kept_.size());
}

void VisibilityBlocks::set(std::size_t block, const Lanes* coefficients) {
    if (place_[block] == kUnoccluded) return;
    FixedLanes* to = &numbers_[place_[block] * kept_.size()];
    for (const std::size_t index : kept_) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float number = std::clamp(coefficients[index][i] * kOne, -32767.0F, 32767.0F);
            to->value[i] = static_cast<std::int16_t>(std::lround(number));
        }
        ++to;
    }
}

void VisibilityBlocks::take_over(std::size_t block, const VisibilityBlocks& before,
                                 const std::array<std::uint32_t, kLanes>& vertices) {
    FixedLanes* const to = &numbers_[place_[block] * kept_.size()];
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::int16_t* from = before.block(vertices[i] / kLanes) + vertices[i] % kLanes;
        for (std::size_t k = 0; k < kept_.size(); ++k) to[k].value[i] = from[k * kLanes];
    }
}

void VisibilityBlocks::expand(std::size_t vertex, std::span<float> out) const {
    const std::int16_t* from = block(vertex / kLanes);
    std::ranges::fill(out, 0.0F);
    if (from == nullptr) {
        out[0] = VisibilityHarmonics::kUnoccluded;
        return;
    }
    from += vertex % kLanes;
    for (const std::size_t index : kept_) {
        out[index] = static_cast<float>(*from) / kOne;
        from += kLanes;
    }
}

}  // namespace nicol
