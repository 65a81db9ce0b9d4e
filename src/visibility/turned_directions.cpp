// SPDX-License-Identifier: MIT
#include "visibility/turned_directions.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

namespace nicol {

TurnedDirections::TurnedDirections(const DirectionSet& directions, const glm::dmat3& rotation)
    : nearest_(directions.size()) {
    const glm::mat3 back(glm::transpose(rotation));
    const std::span all = directions.directions();
    constexpr std::size_t step = RayBundle::kRays;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const glm::vec3 before = back * all[i];
        const auto nearest = [&](std::size_t first, std::size_t last, std::size_t by) {
            std::size_t best = first;
            for (std::size_t k = first; k < last; k += by)
                if (glm::dot(before, all[k]) > glm::dot(before, all[best])) best = k;
            return best;
        };
        // Neighbours in the list are neighbours on the sphere.
        const std::size_t near = nearest(0, all.size(), step);
        nearest_[i] = static_cast<std::uint32_t>(
            nearest(near - std::min(near, step), std::min(near + 2 * step, all.size()), 1));
    }
}

void TurnedDirections::turn(std::span<const std::uint64_t> before, std::span<std::uint64_t> bits) const {
    std::ranges::fill(bits, 0U);
    for (std::size_t i = 0; i < nearest_.size(); ++i) {
        const std::size_t k = nearest_[i];
        bits[i / 64] |= (before[k / 64] >> (k % 64) & 1U) << (i % 64);
    }
}

}  // namespace nicol
