// SPDX-License-Identifier: MIT
// States of vertices after the bake of a part.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "visibility/visibility.hpp"

namespace nicol {

/// State of a vertex whose own rays a bake has traced. 1: it was baked as another vertex in the same pixel,
/// 0: it was not baked.
inline constexpr std::uint8_t kTraced = 2;

/// Returns the states of vertices. needed: NeededVertices::flags. like: of vertices_in_pixels(). Empty: rays
/// of all were traced.
[[nodiscard]] inline std::vector<std::uint8_t> baked_vertices(std::vector<std::uint8_t> needed,
                                                              std::span<const std::uint32_t> like) {
    if (needed.empty()) needed.assign(like.size(), 1);
    for (std::size_t v = 0; v < needed.size(); ++v)
        if (needed[v] != 0 && (like.empty() || like[v] == kNoVertex)) needed[v] = kTraced;
    return needed;
}

[[nodiscard]] inline bool any(std::span<const std::uint8_t> flags) {
    return std::ranges::any_of(flags, [](std::uint8_t flag) { return flag != 0; });
}

/// Returns whether flags contain all that are wanted. Empty: all are set.
[[nodiscard]] inline bool contain(std::span<const std::uint8_t> flags, std::span<const std::uint8_t> wanted) {
    for (std::size_t v = 0; v < flags.size(); ++v)
        if (flags[v] == 0 && (wanted.empty() || wanted[v] != 0)) return false;
    return true;
}

}  // namespace nicol
