// SPDX-License-Identifier: MIT
// Ray tracing for one vertex of a bake.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "visibility/bake_rays.hpp"
#include "visibility/disturbed_rays.hpp"
#include "visibility/flat_blockers.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Result of a former bake for one vertex: its bits, 0 below the plane of the vertex's normal, and the rays
/// of each bundle whose result may differ. Bits of such rays may be any.
struct FormerBits {
    std::span<const std::uint64_t> bits;
    const DisturbedBundles* disturbed;
    bool unoccluded = false;  ///< whether all bits above the plane are known to be 1
};

/// Sets the bits of a vertex, which must be 0, as if nothing were above its horizon. Returns the number of
/// directions there.
std::uint64_t set_open(const DirectionSet& directions, const glm::vec3& normal, std::size_t vertex,
                       Visibility& visibility);

struct RayCounts {
    std::uint64_t traced = 0;
    std::uint64_t skipped = 0;  ///< rays whose result was known without
};

/// Sets the bits of a vertex, which must be 0, by rays from `origin` in the directions above the plane of the
/// unit normal. faces: cones of FlatBlockers to faces of the scene, in which rays are not traced.
RayCounts trace_vertex(const BakeRays& scene, const DirectionSet& directions, const glm::vec3& origin,
                       const glm::vec3& normal, std::size_t vertex, const std::optional<FormerBits>& former,
                       std::span<const FlatBlockers::Cone> faces, Visibility& visibility);

}  // namespace nicol
