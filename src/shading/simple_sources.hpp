// SPDX-License-Identifier: MIT
// Light sources of simple shapes: a direction or distant disc, a point without a size, and a sphere.
#pragma once

#include <glm/mat4x4.hpp>

#include "light/local_light.hpp"
#include "shading/light_source.hpp"

namespace nicol {

/// Returns the source of a local light. `to_axes`: rotation and shift from the light's own axes to the
/// points' axes.
[[nodiscard]] LightSourcePtr simple_source(const LocalLight& light, SourceColor color,
                                           const glm::dmat4& to_axes);

/// Returns the source of a surface whose triangles are closed, face outwards and are nearly a sphere; null
/// for other surfaces. Textures and the inner side are ignored. Light samples are uniform over the solid
/// angle that is visible from a point, so that no sample is wasted on the far side.
[[nodiscard]] LightSourcePtr sphere_source(const EmissiveSurface& surface);

}  // namespace nicol
