// SPDX-License-Identifier: MIT
#include "visibility/visibility_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "harmonics/psh.hpp"

namespace nicol {
namespace {

// Returns whether a vertex of a block is occluded.
bool occluded(const Visibility& visibility, std::size_t block) {
    const std::span unoccluded = visibility.unoccluded().subspan(block * kLanes);
    return std::ranges::any_of(unoccluded.first(std::min(kLanes, unoccluded.size())),
                               [](std::uint8_t flag) { return flag == 0; });
}

}  // namespace

VisibilityBlocks::VisibilityBlocks(const Visibility& visibility, int order)
    : order_(order), vertices_(visibility.vertices()) {
    for (int m = 0; m <= order_; ++m) {
        for (int l = m; l <= order_; l += 2) {
            kept_.push_back(psh_index(l, m));
            if (m > 0) kept_.push_back(psh_index(l, -m));
        }
    }
    numbers_.resize((vertices_ + kLanes - 1) / kLanes);
    for (std::size_t block = 0; block < numbers_.blocks(); ++block) {
        if (occluded(visibility, block)) numbers_.allocate(block, kept_.size());
    }
}

VisibilityBlocks::VisibilityBlocks(VisibilityBlocks&& before, std::span<const std::uint32_t> former,
                                   const Visibility& visibility, int order,
                                   std::vector<std::uint8_t>& missing) {
    if (before.empty()) {
        *this = VisibilityBlocks(visibility, order);
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
    const std::vector<std::uint32_t> unset = numbers_.renumber(
        former, kept_.size(), [&](std::size_t block) { return occluded(visibility, block); }, copy);
    missing.assign(vertices_, 0);
    for (const std::uint32_t v : unset) missing[v] = 1;
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
