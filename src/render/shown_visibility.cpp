// SPDX-License-Identifier: MIT
#include "render/shown_visibility.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace nicol {
namespace {

// Returns the number of directions in which two vertices see different things.
std::size_t differing(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < a.size(); ++i) count += static_cast<std::size_t>(std::popcount(a[i] ^ b[i]));
    return count;
}

}  // namespace

void ShownVisibility::show(std::shared_ptr<const Visibility> baked) {
    shown_ = std::move(baked);
    lagging_.clear();
}

void ShownVisibility::follow(std::shared_ptr<const Visibility> baked, std::span<std::uint32_t> former,
                             std::size_t negligible) {
    const std::shared_ptr<const Visibility> before = std::exchange(shown_, baked);
    std::vector<std::uint8_t> lagging(former.size(), 0);
    using Range = tbb::blocked_range<std::size_t>;
    tbb::parallel_for(Range(0, former.size(), 4096), [&](const Range& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v) {
            if (former[v] == kNoVertex) continue;
            const std::size_t count = differing(baked->at(v), before->at(former[v]));
            if (count > negligible)
                former[v] = kNoVertex;
            else if (count > 0)
                lagging[v] = 1;
        }
    });
    lagging_.clear();
    if (std::ranges::find(lagging, 1) == lagging.end()) return;
    auto shown = std::make_shared<Visibility>(*baked);
    for (std::size_t v = 0; v < lagging.size(); ++v) {
        if (lagging[v] != 0) shown->take(v, *before, former[v]);
    }
    shown_ = std::move(shown);
    lagging_ = std::move(lagging);
}

}  // namespace nicol
