// SPDX-License-Identifier: MIT
#include "geometry/welded_positions.hpp"

#include <bit>
#include <cstddef>

#include "geometry/position_hash.hpp"

namespace nicol {

std::vector<std::uint32_t> welded_positions(std::span<const glm::vec3> positions) {
    constexpr std::uint32_t none = ~std::uint32_t{0};
    // The table holds the first vertex at each position; places that are taken are passed over.
    std::vector<std::uint32_t> first_at(std::bit_ceil(2 * positions.size() + 1), none);
    std::vector<std::uint32_t> first_of(positions.size());
    for (std::uint32_t v = 0; v < positions.size(); ++v) {
        std::size_t place = geometry::hash_of(positions[v]) & (first_at.size() - 1);
        while (first_at[place] != none && positions[first_at[place]] != positions[v])
            place = (place + 1) & (first_at.size() - 1);
        if (first_at[place] == none) first_at[place] = v;
        first_of[v] = first_at[place];
    }
    return first_of;
}

}  // namespace nicol
