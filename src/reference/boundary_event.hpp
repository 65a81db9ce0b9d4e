// SPDX-License-Identifier: MIT
// Reflection or refraction of a path at a smooth boundary that transmits light.
#pragma once

#include <optional>

#include "material/dielectric.hpp"
#include "reference/path_vertex.hpp"
#include "reference/traced_surface.hpp"

namespace nicol {

/// Direction in which a path goes on beyond a smooth boundary.
struct BoundaryEvent {
    Ray ray;                     ///< ray from the boundary towards the light
    Frame incident;              ///< frame of the light that arrives against the ray
    double radiance_scale;       ///< see BoundaryPart
    const SmoothBoundary* body;  ///< body that the ray travels through; null: none
};

/// Chooses reflection or transmission in proportion to their shares of unpolarized light, and moves the
/// path's end from the light that leaves `hit`, in the frame `received`, to the light that arrives. point: in
/// [0, 1). Returns nothing if the boundary absorbs all light.
[[nodiscard]] std::optional<BoundaryEvent> sample_boundary(const SmoothBoundary& boundary,
                                                           const SurfaceHit& hit, const Frame& received,
                                                           double point, PathWorkspace& workspace);

}  // namespace nicol
