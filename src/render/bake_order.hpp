// SPDX-License-Identifier: MIT
// Order in which a bake in slices of time traces vertices.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "scene/projection.hpp"
#include "surfaces/geometry.hpp"
#include "visibility/disturbed_rays.hpp"

namespace nicol {

/// Largest number of changes of a scene that a vertex is known to have waited for.
inline constexpr std::uint8_t kLongestWait = 255;

/// Returns about the part of a point's sky that a change may have affected, 0 to 1.
[[nodiscard]] float part_of_sky(const glm::vec3& point, const Disturbances& change);

/// Returns the blocks of sixteen vertices, those to be traced first first: by the largest part of a vertex in
/// it, far less if no view can show the vertex, times one more than the number of changes that the vertex
/// has waited for. In a scene that changes in every image, each vertex therefore has its turn. parts:
/// part_of_sky() of each vertex. waits: number of changes, up to kLongestWait.
[[nodiscard]] std::vector<std::uint32_t> bake_order(const WorldGeometry& geometry,
                                                    std::span<const Projection> views,
                                                    std::span<const float> parts,
                                                    std::span<const std::uint8_t> waits);

}  // namespace nicol
