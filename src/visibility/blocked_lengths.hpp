// SPDX-License-Identifier: MIT
// Edge lengths that a refinement wants where blocked rays start and end.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/edge_bisection.hpp"
#include "visibility/bake.hpp"

namespace nicol {

/// Follows blocked rays of occluded vertices to their hit points: some rays of some thousands of vertices.
/// Returns a wanted length for each hit point: the ray's length, or the longest edge at the ray's vertex if
/// that is longer. baked: the result of bake(); occluded: numbers of occluded vertices, ascending; shifts:
/// from each vertex to the start of its rays. Runs on the calling thread's TBB arena.
[[nodiscard]] std::vector<WantedLength> blocked_lengths(const BakeGeometry& geometry,
                                                        const DirectionSet& directions,
                                                        const Visibility& baked, const RayScene& scene,
                                                        std::span<const std::uint32_t> occluded,
                                                        std::span<const glm::vec3> shifts);

}  // namespace nicol
