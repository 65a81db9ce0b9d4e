// SPDX-License-Identifier: MIT
#include "surfaces/vertex_stage.hpp"

#include <algorithm>
#include <cstddef>

#include "simd/lanes.hpp"

namespace nicol {

bool CurrentVertices::any_current() const {
    return std::ranges::find(current_, std::uint8_t{1}) != current_.end();
}

bool CurrentVertices::suffices(std::span<const std::uint8_t> needed) const {
    if (has_renumbered_ || !any_current()) return false;
    const std::span<const std::uint8_t> current(current_);
    for (std::size_t first = 0; first < needed.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, needed.size() - first);
        const auto is_set = [](std::uint8_t flag) { return flag != 0; };
        if (std::ranges::any_of(needed.subspan(first, count), is_set) &&
            !std::ranges::all_of(current.subspan(first, count), is_set))
            return false;
    }
    return true;
}

bool CurrentVertices::update(const SurfaceState& surfaces, bool same_inputs) {
    const bool same = same_inputs && surfaces_ == surfaces.versions;
    const bool follows = same_inputs && surfaces.change && surfaces_ == surfaces.change->before;
    complete_ = complete_ && same;
    if (!same) {
        // Parts that were to be moved for an earlier change, and were not, are lost.
        if (follows && !has_renumbered_) {
            follow(*surfaces.change);
        } else {
            current_.resize(surfaces.geometry.positions.size());
            discard();
        }
    }
    surfaces_ = surfaces.versions;
    if (dependence_.on_materials) discard_ranges(surfaces.geometry.ranges);
    return !complete_;
}

void CurrentVertices::follow(const SurfaceChange& change) {
    const std::size_t vertices = change.former.size();
    std::vector<std::uint8_t> current(vertices, 0);
    former_.assign(vertices, kNoVertex);
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::uint32_t before = change.former[v];
        if (before >= current_.size() || current_[before] == 0) continue;
        if (dependence_.on_places && change.same_places[v] == 0) continue;
        if (before != v && !dependence_.renumbers) continue;
        if (!dependence_.turns && !change.same_normals.empty() && change.same_normals[v] == 0) continue;
        current[v] = 1;
        former_[v] = before;
        has_renumbered_ = has_renumbered_ || before != v;
    }
    current_ = std::move(current);
}

void CurrentVertices::renumbered() {
    former_.resize(current_.size());
    for (std::size_t v = 0; v < former_.size(); ++v)
        former_[v] = current_[v] != 0 ? static_cast<std::uint32_t>(v) : kNoVertex;
    has_renumbered_ = false;
}

void CurrentVertices::discard() {
    std::ranges::fill(current_, std::uint8_t{0});
    renumbered();
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
    renumbered();
    complete_ = true;
}

void CurrentVertices::complete(std::span<const std::uint8_t> computed) {
    for (std::size_t v = 0; v < computed.size(); ++v) {
        if (computed[v] != 0) current_[v] = 1;
    }
    renumbered();
}

}  // namespace nicol
