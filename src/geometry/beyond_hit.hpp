// SPDX-License-Identifier: MIT
// Rays that begin behind what they hit, and that end before a light.
#pragma once

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Returns the value of Ray::nearest that leaves out a hit surface. offset: ray_offset() of the hit triangle.
/// The result is larger than the hit's distance as a 32-bit float, too, so that a ray that goes on again and
/// again comes to an end.
[[nodiscard]] inline double beyond(const RayHit& hit, double offset) {
    return hit.distance * (1 + kRayOffset) + offset;
}

/// Returns the distance where a shadow ray ends, before a light at a distance, so that the light's own
/// surface does not hide it. origin: the largest coordinate of the ray's origin.
[[nodiscard]] inline double before_light(double distance, double origin) {
    constexpr double left_out = 1e-4;
    return (1 - left_out) * distance - kRayOffset * origin;
}

}  // namespace nicol
