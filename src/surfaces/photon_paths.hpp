// SPDX-License-Identifier: MIT
// Paths of light from lamps over smooth surfaces to other surfaces.
#pragma once

#include <cstddef>
#include <memory>
#include <span>

#include "shading/focused_light.hpp"
#include "shading/light_source.hpp"
#include "surfaces/geometry.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {

/// Surfaces that photons meet.
struct PhotonScene {
    const WorldGeometry& geometry;
    const SmoothSurfaces& smooth;
    int events;            ///< largest number of reflections and refractions on a path
    std::size_t channels;  ///< of the image
};

/// Follows light from sources over smooth glass and mirrors, those that cast shadows, until it meets another
/// surface that the camera sees. Light that passes glass straight alone is left out, because shadow rays let
/// it pass. Returns null if next to no light arrives. Runs on the calling thread's TBB arena; the result does
/// not depend on the number of threads.
[[nodiscard]] std::shared_ptr<const FocusedLight> focused_light(const PhotonScene& scene,
                                                                std::span<const LightSourcePtr> sources);

}  // namespace nicol
