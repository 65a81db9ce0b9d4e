// SPDX-License-Identifier: MIT
// The reference method (see reference/reference.hpp).
#pragma once

#include "image/aovs.hpp"
#include "image/stokes_image.hpp"
#include "reference/direct_light.hpp"
#include "reference/reference.hpp"
#include "scene/projection.hpp"
#include "scene/scene.hpp"

namespace nicol {

/// For each pixel the mean, over the pixel's square, of the light towards the camera in the frame field of
/// the viewpoint. Where a ray meets a surface this is the integral over the hemisphere about the interpolated
/// normal of M(towards light, towards viewer) L(towards light) cos, L being that of the environment, of small
/// lights and of surfaces that shine, where no triangle is in the way if shadows are asked for; 0 where the
/// viewer is behind that normal, unless the material is two-sided; and what the surface emits itself.
/// Elsewhere it is the environment. Plates before that act on it. `projection` must have been made for this
/// width and height. Throws Error(invalid_argument) for options or sizes out of range, the variance of a
/// single sample among them, Error(out_of_memory), Error(cancelled), and what the environment and the
/// materials throw. `aovs`, where not null, gets the AOVs of the options: the variance as PixelEstimate has
/// it, the others by the rays through the pixels' centres.
[[nodiscard]] StokesImage render_reference(const Scene& scene, const Projection& projection, int width,
                                           int height, const ReferenceOptions& options,
                                           ReferenceStatistics& statistics,
                                           Strategy strategy = Strategy::both, Aovs* aovs = nullptr);

}  // namespace nicol
