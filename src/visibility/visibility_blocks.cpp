// SPDX-License-Identifier: MIT
#include "visibility/visibility_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "harmonics/psh.hpp"

namespace nicol {
namespace {

// Returns whether any flag of a block has this value.
bool any_of(std::span<const std::uint8_t> flags, std::size_t block, std::uint8_t value) {
    const std::span of_block = flags.subspan(block * kLanes);
    return std::ranges::any_of(of_block.first(std::min(kLanes, of_block.size())),
                               [value](std::uint8_t flag) { return flag == value; });
}

bool occluded(const Visibility& visibility, std::size_t block) {
    return any_of(visibility.unoccluded(), block, 0);
}

bool is_needed(std::span<const std::uint8_t> needed, std::size_t block) {
    return needed.empty() || any_of(needed, block, 1);
}

}  // namespace

VisibilityBlocks::VisibilityBlocks(const Visibility& visibility, int order,
                                   std::span<const std::uint8_t> needed)
    : order_(order), vertices_(visibility.vertices()) {
    for (int m = 0; m <= order_; ++m) {
        for (int l = m; l <= order_; l += 2) {
            kept_.push_back(psh_index(l, m));
            if (m > 0) kept_.push_back(psh_index(l, -m));
        }
    }
    numbers_.resize((vertices_ + kLanes - 1) / kLanes);
    left_out_.assign(numbers_.blocks(), 0);
    for (std::size_t block = 0; block < numbers_.blocks(); ++block) {
        if (!occluded(visibility, block)) continue;
        if (is_needed(needed, block))
            numbers_.allocate(block, kept_.size());
        else
            left_out_[block] = 1;
    }
}

VisibilityBlocks::VisibilityBlocks(VisibilityBlocks&& before, std::span<const std::uint32_t> former,
                                   const Visibility& visibility, int order,
                                   std::vector<std::uint8_t>& missing, std::span<const std::uint8_t> needed) {
    if (before.empty()) {
        *this = VisibilityBlocks(visibility, order, needed);
        missing.clear();
        for (std::size_t v = 0; v < vertices_; ++v)
            missing.push_back(numbers_.at(v / kLanes) == nullptr ? 0 : 1);
        return;
    }
    *this = std::move(before);
    order_ = order;
    vertices_ = visibility.vertices();
    const auto copy = [this](FixedLanes* to, std::size_t lane, const FixedLanes* from,
                             std::size_t lane_before) {
        for (std::size_t k = 0; k < kept_.size(); ++k) to[k].value[lane] = from[k].value[lane_before];
    };
    left_out_.assign((vertices_ + kLanes - 1) / kLanes, 0);
    const auto wanted = [&](std::size_t block) {
        if (!occluded(visibility, block)) return false;
        const auto of_block =
            former.subspan(block * kLanes, std::min(kLanes, former.size() - block * kLanes));
        const bool known = std::ranges::find(of_block, kNoVertex) == of_block.end();
        const bool kept = known || is_needed(needed, block);
        left_out_[block] = kept ? 0 : 1;
        return kept;
    };
    const std::vector<std::uint32_t> unset = numbers_.renumber(former, kept_.size(), wanted, copy);
    missing.assign(vertices_, 0);
    for (const std::uint32_t v : unset) missing[v] = 1;
}

void VisibilityBlocks::find_computed(std::span<std::uint8_t> computed) const {
    for (std::size_t v = 0; v < vertices_; ++v) computed[v] = left_out_[v / kLanes] != 0 ? 0 : 1;
}

void VisibilityBlocks::set(std::span<const std::uint32_t> vertices, const Lanes* coefficients) {
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        FixedLanes* to = numbers_.at(vertices[i] / kLanes);
        if (to == nullptr) continue;
        for (const std::size_t index : kept_) {
            const float number = std::clamp(coefficients[index][i] * kOne, -32767.0F, 32767.0F);
            to++->value[vertices[i] % kLanes] = static_cast<std::int16_t>(std::lround(number));
        }
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
