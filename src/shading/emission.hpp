// SPDX-License-Identifier: MIT
// Emission of surfaces towards a viewpoint.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "light/local_light.hpp"
#include "polarization/views.hpp"

namespace nicol {

/// Adds to out[c][i] channel c's Stokes vector of the light that the surface emits from position i towards
/// the viewpoint, in the camera's frame field. Adds nothing if the viewer is behind the normal. `axis`: axis
/// of the polarization, in the positions' axes. `points`: one for each position if the emission has a
/// texture. Light of one channel serves all.
void add_emitted(const Emission& emission, const glm::dvec3& axis, const Views& views,
                 std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
                 std::span<const TexturePoint> points, std::span<const std::span<glm::vec4>> out);

}  // namespace nicol
