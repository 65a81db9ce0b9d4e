// SPDX-License-Identifier: MIT
#include "visibility/visibility_blocks.hpp"

#include <tbb/parallel_for.h>

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
    find_places(visibility);
    numbers_.resize(stored_ * kept_.size());
}

VisibilityBlocks::VisibilityBlocks(VisibilityBlocks&& before, std::span<const std::uint32_t> former,
                                   const Visibility& visibility, int order,
                                   std::vector<std::uint8_t>& missing) {
    if (before.empty()) {
        *this = VisibilityBlocks(visibility, order);
        missing.clear();
        for (const std::uint32_t place : place_) missing.push_back(place == kUnoccluded ? 0 : 1);
        return;
    }
    order_ = order;
    vertices_ = visibility.vertices();
    kept_ = before.kept_;
    find_places(visibility);
    missing.assign(place_.size(), 0);
    bool moved = place_ != before.place_;
    for (std::size_t v = 0; v < vertices_ && !moved; ++v) moved = former[v] != v && former[v] != kNoVertex;
    if (!moved) numbers_ = std::move(before.numbers_);
    numbers_.resize(stored_ * kept_.size());
    tbb::parallel_for(std::size_t{0}, place_.size(), [&](std::size_t block) {
        if (place_[block] == kUnoccluded) return;
        const auto vertices = before.known(block, former);
        missing[block] = vertices ? 0 : 1;
        if (!vertices || !moved) return;
        FixedLanes* const to = &numbers_[place_[block] * kept_.size()];
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::int16_t* from = before.block((*vertices)[i] / kLanes) + (*vertices)[i] % kLanes;
            for (std::size_t k = 0; k < kept_.size(); ++k) to[k].value[i] = from[k * kLanes];
        }
    });
}

void VisibilityBlocks::find_places(const Visibility& visibility) {
    for (std::size_t begin = 0; begin < vertices_; begin += kLanes) {
        const auto block = visibility.unoccluded().subspan(begin, std::min(kLanes, vertices_ - begin));
        const bool shadowed = std::ranges::any_of(block, [](std::uint8_t v) { return v == 0; });
        place_.push_back(shadowed ? stored_++ : kUnoccluded);
    }
}

std::optional<std::array<std::uint32_t, kLanes>> VisibilityBlocks::known(
    std::size_t block, std::span<const std::uint32_t> former) const {
    std::array<std::uint32_t, kLanes> out{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        out[i] = former[std::min(block * kLanes + i, former.size() - 1)];
        if (out[i] == kNoVertex || place_[out[i] / kLanes] == kUnoccluded) return std::nullopt;
    }
    return out;
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
