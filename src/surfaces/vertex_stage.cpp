// SPDX-License-Identifier: MIT
#include "surfaces/vertex_stage.hpp"

#include <algorithm>
#include <cstddef>

namespace nicol {

bool CurrentVertices::any_current() const {
    return std::ranges::find(current_, std::uint8_t{1}) != current_.end();
}

bool CurrentVertices::update(const SurfaceState& surfaces, bool same_inputs) {
    const std::size_t vertices = surfaces.geometry.positions.size();
    const bool same = same_inputs && surfaces_ == surfaces.versions;
    const bool follows = same_inputs && surfaces.change && surfaces_ == surfaces.change->before;
    complete_ = complete_ && same;
    if (!same && follows) {
        current_.resize(vertices, 0);
        const SurfaceChange& change = *surfaces.change;
        for (std::size_t v = 0; v < vertices; ++v) {
            if (change.same_field[v] == 0 || (dependence_.on_places && change.same_places[v] == 0))
                current_[v] = 0;
        }
    } else if (!same) {
        current_.assign(vertices, 0);
    }
    surfaces_ = surfaces.versions;
    if (dependence_.on_materials) discard_ranges(surfaces.geometry.ranges);
    return !complete_;
}

void CurrentVertices::discard_ranges(const std::vector<VertexRange>& ranges) {
    if (ranges_ == ranges) return;
    for (std::size_t i = 0; i < ranges.size(); ++i) {
        if (i < ranges_.size() && ranges_[i] == ranges[i]) continue;
        std::fill(current_.begin() + static_cast<std::ptrdiff_t>(ranges[i].first),
                  current_.begin() + static_cast<std::ptrdiff_t>(ranges[i].last), std::uint8_t{0});
    }
    ranges_ = ranges;
    complete_ = false;
}

void CurrentVertices::complete() {
    std::ranges::fill(current_, std::uint8_t{1});
    complete_ = true;
}

void CurrentVertices::complete(std::span<const std::uint8_t> computed) {
    for (std::size_t v = 0; v < computed.size(); ++v) {
        if (computed[v] != 0) current_[v] = 1;
    }
}

}  // namespace nicol
