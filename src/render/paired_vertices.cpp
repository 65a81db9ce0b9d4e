// SPDX-License-Identifier: MIT
#include "render/paired_vertices.hpp"

#include <algorithm>
#include <unordered_map>

#include "geometry/position_hash.hpp"

namespace nicol {

std::vector<std::uint32_t> paired_vertices(std::size_t given, const RefinedVertices& before,
                                           const RefinedVertices& now) {
    std::vector<std::uint32_t> out(now.visibility.vertices(), kNoVertex);
    for (std::size_t i = 0; i < given; ++i) out[now.numbers.number(i)] = before.numbers.number(i);
    std::unordered_map<std::size_t, std::uint32_t> added;
    const auto hash = [](const WorldGeometry& geometry, std::uint32_t v) {
        return geometry::hash_of(geometry.positions[v], geometry.normals[v]);
    };
    for (std::size_t i = given; i < given + before.added; ++i)
        added.try_emplace(hash(*before.geometry, before.numbers.number(i)), before.numbers.number(i));
    for (std::size_t i = given; i < given + now.added; ++i) {
        const std::uint32_t v = now.numbers.number(i);
        const auto found = added.find(hash(*now.geometry, v));
        if (found == added.end()) continue;
        const std::uint32_t w = found->second;
        if (before.geometry->positions[w] == now.geometry->positions[v] &&
            before.geometry->normals[w] == now.geometry->normals[v] &&
            std::ranges::equal(before.visibility.at(w), now.visibility.at(v)))
            out[v] = w;
    }
    for (std::uint32_t v = 0; v < out.size(); ++v)
        if (now.numbers.is_copy(v) && out[v - 1] != kNoVertex) out[v] = before.numbers.next_copy(out[v - 1]);
    return out;
}

}  // namespace nicol
