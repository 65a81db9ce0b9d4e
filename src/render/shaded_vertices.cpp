// SPDX-License-Identifier: MIT
#include "render/shaded_vertices.hpp"

#include <algorithm>

namespace nicol {

void ShadedVertices::follow(const Key& key, const TransferInput& input,
                            std::span<const std::uint8_t> same_places) {
    const std::size_t vertices = input.geometry.positions.size();
    const bool same = geometry_ == input.geometry_revision && visibility_ == input.visibility_revision;
    const bool follows = input.unchanged && input.unchanged->geometry == geometry_ &&
                         input.unchanged->visibility == visibility_;
    if (key_ != key || (!same && !follows)) {
        right_.assign(vertices, 0);
    } else if (!same) {
        right_.resize(vertices, 0);
        for (std::size_t v = 0; v < vertices; ++v) {
            right_[v] = right_[v] != 0 && input.unchanged->vertices[v] != 0 && same_places[v] != 0 ? 1 : 0;
        }
    }
    if (ranges_ != input.geometry.ranges) {
        const auto& ranges = input.geometry.ranges;
        for (std::size_t i = 0; i < ranges.size(); ++i) {
            if (i < ranges_.size() && ranges_[i] == ranges[i]) continue;
            std::fill(right_.begin() + static_cast<std::ptrdiff_t>(ranges[i].first),
                      right_.begin() + static_cast<std::ptrdiff_t>(ranges[i].last), std::uint8_t{0});
        }
        ranges_ = ranges;
    }
    key_ = key;
    geometry_ = input.geometry_revision;
    visibility_ = input.visibility_revision;
}

std::span<const std::uint8_t> ShadedVertices::choose(std::span<const std::uint8_t> visible) {
    chosen_.resize(visible.size());
    for (std::size_t v = 0; v < visible.size(); ++v) {
        chosen_[v] = visible[v] != 0 && right_[v] == 0 ? 1 : 0;
    }
    return chosen_;
}

std::uint64_t ShadedVertices::chosen_count() const {
    return static_cast<std::uint64_t>(std::ranges::count(chosen_, std::uint8_t{1}));
}

void ShadedVertices::done() {
    for (std::size_t v = 0; v < chosen_.size(); ++v) right_[v] |= chosen_[v];
}

}  // namespace nicol
