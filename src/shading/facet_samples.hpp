// SPDX-License-Identifier: MIT
// Samples of the facets of rough surfaces.
#pragma once

#include "material/material.hpp"
#include "polarization/lane_points.hpp"

namespace nicol {

/// Samples the reflection off facets, with a density close to that of the reflected light. Computes unit
/// directions towards the light, which u and v in [0, 1) choose, and their density per steradian; all
/// directions are in the surface's frame, whose z is the normal. Facets of GGX are those that the viewer sees
/// (Heitz 2018), those of Beckmann have the density of all facets (Walter et al. 2007).
void sample_facets(const Lobe& lobe, const LaneVectors& towards_viewer, const Lanes& u, const Lanes& v,
                   LaneVectors& towards_light, Lanes& density);

}  // namespace nicol
