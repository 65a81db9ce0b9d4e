// SPDX-License-Identifier: MIT
// Light of an environment whose axes are not those of the points that it lights.
#pragma once

#include <glm/mat3x3.hpp>

#include "light/lane_light.hpp"

namespace nicol {

/// Computes the light from out.towards: look_up() is called with these directions rotated to the
/// environment's axes, and must compute `out` but for the directions; its frames are rotated back and its
/// light is scaled. to_points: rotation from the environment's axes to the points'.
template <class LookUp>
void look_up_rotated(const glm::mat3& to_points, float scale, LaneLight& out, const LookUp& look_up) {
    const LaneVectors directions = out.towards;
    for (std::size_t i = 0; i < kLanes; ++i) put(out.towards, i, vector_at(directions, i) * to_points);
    look_up();
    out.towards = directions;
    for (std::size_t i = 0; i < kLanes; ++i) put(out.x, i, to_points * vector_at(out.x, i));
    for (std::array<Lanes, 4>& stokes : out.irradiance)
        for (std::size_t p = 0; p < out.components; ++p)
            for (std::size_t i = 0; i < kLanes; ++i) stokes[p][i] *= scale;
}

}  // namespace nicol
