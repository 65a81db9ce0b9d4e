// SPDX-License-Identifier: MIT
// Normals that a texture turns.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "material/spatial_variation.hpp"
#include "polarization/lane_points.hpp"

namespace nicol {

/// How a triangle's points move as texture coordinates grow. Both 0 where all of the triangle has texture
/// coordinates on one line.
struct TextureAxes {
    glm::vec3 by_u{0};
    glm::vec3 by_v{0};
};
/// Of sixteen triangles.
struct LaneTextureAxes {
    LaneVectors by_u, by_v;
};
/// Of a triangle.
[[nodiscard]] TextureAxes texture_axes(const std::array<glm::vec3, 3>& positions,
                                       const std::array<glm::vec2, 3>& texcoords);

/// The unit normal at a point, from the interpolated one, also unit; the latter where `axes` are 0 or the
/// texture gives no direction. `back`: the normal is that of the back of a two-sided surface, which is turned
/// as a front's that points the other way.
///
/// map: (x, y, z) = 2 t - 1 in the frame of x = the direction of by_u within the surface, z = the normal and
/// y = z cross x; or of mirrored charts -y, see NormalVariation. bump: the normal of the surface moved along
/// its normal by scale times t (Blinn 1978): the cross product of by_u + (scale dt/du - n by_u) n and the
/// same for v. Both as in Mitsuba 3.
[[nodiscard]] glm::vec3 perturbed_normal(const NormalVariation& variation, const TexturePoint& point,
                                         const TextureAxes& axes, const glm::vec3& normal, bool back);

/// A perturbed normal that faces away from the viewer, more than the interpolated one does, is moved to where
/// it does not, about a degree from edge-on: the other side of the surface cannot be seen. All unit.
[[nodiscard]] glm::vec3 facing(const glm::vec3& turned, const glm::vec3& normal,
                               const glm::vec3& towards_viewer);

/// Of sixteen points what facing() makes of perturbed_normal(). towards_viewer: of any length but 0.
void turn_normals(const NormalVariation& variation, const TexturePoints& points, const LaneTextureAxes& axes,
                  bool back, const LaneVectors& towards_viewer, LaneVectors& normals);

}  // namespace nicol
