// SPDX-License-Identifier: MIT
// Evaluation of filtered light at sixteen directions at once.
#pragma once

#include "simd/lanes.hpp"
#include "specular/lane_mirror.hpp"
#include "specular/lobe_map.hpp"

namespace nicol {

/// Evaluates the light at directions in its own axes, in frames with the x axis `x` (unit, orthogonal to the
/// direction). out: s0 of each channel and up to three unused numbers for an unpolarized map; the Stokes
/// vectors, [channel][component], for a polarized map. The result is an unspecified value of the map for a
/// direction that is not a unit vector.
void sample_lobe(const LobeMap& map, const LaneVectors& direction, const LaneVectors& x, Lanes* out);

}  // namespace nicol
