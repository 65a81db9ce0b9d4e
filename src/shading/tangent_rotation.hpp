// SPDX-License-Identifier: MIT
// Axes of anisotropic materials that a texture or an angle rotates.
#pragma once

#include <glm/vec3.hpp>

#include "material/spatial_variation.hpp"
#include "shading/normal_variation.hpp"

namespace nicol {

/// Returns the x axis of an anisotropic material at a point, perpendicular to the unit normal of the front:
/// the direction of axes.by_u, rotated. Unit, or 0 if the axes are 0. As in glTF (KHR_materials_anisotropy).
[[nodiscard]] glm::vec3 rotated_tangent(const TangentRotation& rotation, const TexturePoint& point,
                                        const TextureAxes& axes, const glm::vec3& normal);

}  // namespace nicol
