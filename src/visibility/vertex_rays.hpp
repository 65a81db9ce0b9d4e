// SPDX-License-Identifier: MIT
// The rays of a bake from one point.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "geometry/ray_scene.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// What a former bake says of one vertex: its bits, and 1 for the bundles of directions to trace again.
struct FormerBits {
    std::span<const std::uint64_t> bits;
    std::span<const std::uint8_t> disturbed;
};

/// Fills the bits of a vertex, which are 0 before, by rays from `origin` in the directions above the plane of
/// the unit normal. Returns the number of rays.
std::uint64_t trace_vertex(const RayScene& scene, const DirectionSet& directions, const glm::vec3& origin,
                           const glm::vec3& normal, std::size_t vertex,
                           const std::optional<FormerBits>& former, Visibility& visibility);

}  // namespace nicol
