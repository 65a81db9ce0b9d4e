// SPDX-License-Identifier: MIT
// Areas of surfaces that receivers of bounced light stand for.
#pragma once

#include <vector>

#include "geometry/ray_scene.hpp"
#include "methods/linked_surfaces.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Returns the area that interpolation gives to each receiver. present: presence_of(geometry); absent surface
/// has no area.
[[nodiscard]] std::vector<double> areas_of_receivers(const WorldGeometry& geometry,
                                                     const LinkedSurfaces& surfaces, const Presence& present);

}  // namespace nicol
