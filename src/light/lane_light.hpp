// SPDX-License-Identifier: MIT
// Light that reaches sixteen points from one light sample each.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "polarization/lane_points.hpp"

namespace nicol {

struct LaneLight {
    LaneVectors towards;         ///< unit vector towards the light sample
    Lanes distance;              ///< distance to the light sample; infinite for the sky
    LaneVectors x;               ///< unit vector, x of the Stokes frames whose z is -towards
    std::uint32_t points = 0;    ///< bit i: light reaches point i, unless a surface is in between
    std::size_t components = 1;  ///< nonzero components of the Stokes vectors: 1, 3 or 4
    /// Stokes vectors of the irradiance on a surface that faces the light, for each channel, or one for all
    /// channels. For light from an area, the irradiance is radiance times solid angle, so that the mean over
    /// light samples is the irradiance of the whole area.
    std::vector<std::array<Lanes, 4>> irradiance;
};

}  // namespace nicol
