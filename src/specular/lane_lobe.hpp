// SPDX-License-Identifier: MIT
// Look-ups of filtered light, sixteen directions at once.
#pragma once

#include "simd/lanes.hpp"
#include "specular/lane_mirror.hpp"
#include "specular/lobe_map.hpp"

namespace nicol {

/// The light at directions in its own axes, with x (unit, across them) for the frame's x. out: of an
/// unpolarized map s0 of each channel and up to three numbers to spare, of a polarized one the Stokes
/// vectors, [channel][component]. Directions that are no unit vectors give unspecified values of the map.
void sample_lobe(const LobeMap& map, const LaneVectors& direction, const LaneVectors& x, Lanes* out);

}  // namespace nicol
