// SPDX-License-Identifier: MIT
// Inputs of a bake of a scene's surfaces, and its statistics.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stage/options.hpp"
#include "stage/statistics.hpp"
#include "surfaces/scene_geometry.hpp"
#include "surfaces/surface_rays.hpp"
#include "visibility/bake.hpp"

namespace nicol {

/// Returns flags that are 0 for the vertices whose visibility an image does not need (empty: none) and for
/// those that receive no shadows. `room` holds the result if there are any of the latter.
[[nodiscard]] std::span<const std::uint8_t> traced_of(const WorldGeometry& geometry,
                                                      std::span<const std::uint8_t> needed,
                                                      std::vector<std::uint8_t>& room);

/// Returns the surfaces as a bake takes them. rays: of the surfaces, which must outlive the result. needed:
/// as BakeGeometry::needed.
[[nodiscard]] BakeGeometry bake_geometry(const SceneGeometry& surfaces, SurfaceRays& rays,
                                         std::span<const std::uint8_t> needed, const RenderOptions& options);

/// Adds a bake to the statistics of a render. watch: started with the bake.
void count_bake(const BakeStatistics& baked, const Stopwatch& watch, Statistics& statistics);

}  // namespace nicol
