// SPDX-License-Identifier: MIT
// Paths of light from local lights over smooth surfaces to other surfaces.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "shading/focused_light.hpp"
#include "shading/light_source.hpp"
#include "stage/workers.hpp"
#include "surfaces/geometry.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {

/// Largest number of reflections and refractions at smooth surfaces, on paths of light and of rays from
/// pixels.
inline constexpr int kMostSmoothEvents = 64;

/// Surfaces that photons meet.
struct PhotonScene {
    const WorldGeometry& geometry;
    const SmoothSurfaces& smooth;
    int events;  ///< largest number of reflections and refractions on a path; at most kMostSmoothEvents count
    std::size_t channels;  ///< of the image
};

/// Returns the largest number of bytes of focused_light(). surfaces, sources: the number of smooth surfaces,
/// both sides of two-sided ones counted, and of sources, both above 0.
[[nodiscard]] std::size_t most_focused_bytes(std::size_t surfaces, std::size_t sources, std::size_t channels);

/// Follows light from sources over smooth glass and mirrors, those that cast shadows. Light ends at the first
/// other surface that casts shadows. Surfaces without shadows on the way also receive it; surfaces that
/// receive no shadows are left out. Light that passes glass straight alone is left out, because shadow rays
/// let it pass. Returns null if next to no light arrives. Runs on the run's threads, reports progress and
/// counts the rays; the result does not depend on the number of threads. Throws Error(cancelled).
[[nodiscard]] std::shared_ptr<const FocusedLight> focused_light(const PhotonScene& scene,
                                                                std::span<const LightSourcePtr> sources,
                                                                RenderRun& run);

}  // namespace nicol
