// SPDX-License-Identifier: MIT
// Rays that go on behind what they hit.
#pragma once

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Returns the value of Ray::nearest that leaves out a hit surface. offset: ray_offset() of the hit triangle.
/// The result is larger than the hit's distance as a 32-bit float, too, so that a ray that goes on again and
/// again comes to an end.
[[nodiscard]] inline double beyond(const RayHit& hit, double offset) {
    return hit.distance * (1 + kRayOffset) + offset;
}

}  // namespace nicol
