// SPDX-License-Identifier: MIT
#include "render/bake_order.hpp"

#include <algorithm>
#include <functional>
#include <glm/geometric.hpp>
#include <numeric>

#include "simd/lanes.hpp"

namespace nicol {
namespace {

// Weight of a vertex that cannot be seen, relative to one that can.
constexpr float kUnseen = 1.0F / 64;

}  // namespace

float part_of_sky(const glm::vec3& point, const Disturbances& change) {
    float most = 0;
    for (const std::span<const Ball> balls : {change.added, change.removed})
        for (const Ball& ball : balls) {
            const glm::vec3 to = ball.centre - point;
            const float square = ball.radius * ball.radius;
            most = std::max(most, square / std::max(glm::dot(to, to), square));
        }
    return most;
}

std::vector<std::uint32_t> bake_order(const WorldGeometry& geometry, std::span<const Projection> views,
                                      std::span<const float> parts, std::span<const std::uint8_t> waits) {
    std::vector<std::uint8_t> seen(parts.size(), 0), in_view;
    for (const Projection& view : views) {
        find_visible(geometry, view, in_view);
        for (std::size_t v = 0; v < seen.size(); ++v) seen[v] |= in_view[v];
    }
    std::vector<float> weights((parts.size() + kLanes - 1) / kLanes, 0.0F);
    for (std::size_t v = 0; v < parts.size(); ++v) {
        const float weight = (seen[v] != 0 ? 1 : kUnseen) * parts[v] * (1 + static_cast<float>(waits[v]));
        weights[v / kLanes] = std::max(weights[v / kLanes], weight);
    }
    std::vector<std::uint32_t> order(weights.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, std::greater(), [&](std::uint32_t block) { return weights[block]; });
    return order;
}

}  // namespace nicol
