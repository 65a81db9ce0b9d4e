// SPDX-License-Identifier: MIT
// What reaches sixteen points from one place of a light.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "polarization/lane_points.hpp"

namespace nicol {

struct LaneLight {
    LaneVectors towards;         ///< unit, to where the light is
    Lanes distance;              ///< to there; infinite from the sky
    LaneVectors x;               ///< unit, x of the Stokes frames whose z is -towards
    std::uint32_t points = 0;    ///< bit i: light reaches point i, unless something is in between
    std::size_t components = 1;  ///< of the Stokes vectors, the others are 0: 1, 3 or 4
    /// Of each channel, or of one that serves all: Stokes vectors of the irradiance on a surface that faces
    /// the light. Of light from an area this is radiance times solid angle: the mean over samples is the
    /// whole.
    std::vector<std::array<Lanes, 4>> irradiance;
};

}  // namespace nicol
