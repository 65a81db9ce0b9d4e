// SPDX-License-Identifier: MIT
// Ray tracing for one vertex of a bake.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "geometry/ray_scene.hpp"
#include "visibility/disturbed_rays.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Result of a former bake for one vertex: its bits, and the rays of each bundle whose result may differ.
struct FormerBits {
    std::span<const std::uint64_t> bits;
    const DisturbedBundles* disturbed;
};

/// Sets the bits of a vertex, which must be 0, as if nothing were above its horizon. Returns the number of
/// directions there.
std::uint64_t set_open(const DirectionSet& directions, const glm::vec3& normal, std::size_t vertex,
                       Visibility& visibility);

/// Sets the bits of a vertex, which must be 0, by rays from `origin` in the directions above the plane of the
/// unit normal. Returns the number of rays.
std::uint64_t trace_vertex(const RayScene& scene, const DirectionSet& directions, const glm::vec3& origin,
                           const glm::vec3& normal, std::size_t vertex,
                           const std::optional<FormerBits>& former, Visibility& visibility);

}  // namespace nicol
