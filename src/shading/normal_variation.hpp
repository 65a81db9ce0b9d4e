// SPDX-License-Identifier: MIT
// Normals perturbed by a texture.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "material/spatial_variation.hpp"
#include "polarization/lane_points.hpp"

namespace nicol {

/// Derivatives of a triangle's points by texture coordinates. Both are 0 if all texture coordinates of the
/// triangle lie on one line.
struct TextureAxes {
    glm::vec3 by_u{0};
    glm::vec3 by_v{0};
};
/// Texture axes at sixteen points.
struct LaneTextureAxes {
    LaneVectors by_u, by_v;
};
/// Returns the texture axes of one triangle.
[[nodiscard]] TextureAxes texture_axes(const std::array<glm::vec3, 3>& positions,
                                       const std::array<glm::vec2, 3>& texcoords);

/// Returns axes like texture_axes() at a point of a triangle whose corners have these tangents
/// (Mesh::tangents), or `otherwise` if the tangents are 0. Only the direction of by_u, and whether y points
/// to where v falls, are meant. normal: unit normal of the front.
[[nodiscard]] TextureAxes tangent_axes(const std::array<glm::vec4, 3>& tangents, const glm::vec3& weights,
                                       const glm::vec3& normal, const TextureAxes& otherwise);

/// Axes x and y within a surface.
struct SurfaceAxes {
    glm::vec3 x, y;
};
/// Returns x = the direction of by_u within the surface, and y = z cross x for its unit normal z or, with
/// mirrored_y, the opposite where that points to where v grows. Both are 0 if x has no direction.
[[nodiscard]] SurfaceAxes surface_axes(const TextureAxes& axes, const glm::vec3& normal, bool mirrored_y);

/// Returns the perturbed unit normal at a point, from the interpolated unit normal. Returns the interpolated
/// normal if `axes` are 0 or the texture gives no direction. `back`: the normal is that of the back of a
/// two-sided surface; the opposite normal is perturbed as that of a front, and the result is mirrored or
/// reversed as NormalVariation says.
///
/// map: (x, y, z) = 2 t - 1 in the frame of surface_axes() and the normal. bump: the normal of the surface
/// displaced along its normal by scale times t (Blinn 1978): the cross product of by_u + (scale dt/du - n
/// by_u) n and by_v + (scale dt/dv - n by_v) n. Both are defined as in Mitsuba 3.
[[nodiscard]] glm::vec3 perturbed_normal(const NormalVariation& variation, const TexturePoint& point,
                                         const TextureAxes& axes, const glm::vec3& normal, bool back);

/// Returns a perturbed normal that faces the viewer at least as much as the interpolated normal does, up to
/// about a degree from edge-on. The correction is needed because the other side of the surface cannot be
/// seen. A normal that faces away is rotated by half a turn around the interpolated normal first (Schuessler
/// et al. 2017; `flip_invalid_normals` of Mitsuba 3). All vectors are unit.
[[nodiscard]] glm::vec3 facing(const glm::vec3& turned, const glm::vec3& normal,
                               const glm::vec3& towards_viewer);

/// Returns the factor of light on a perturbed normal that hides the abrupt end of the light where it falls at
/// a slant: the shadowing of a microfacet surface whose facets are as steep as the perturbation (Conty
/// Estevez et al. 2019; `use_shadowing_function` of Mitsuba 3). Cosines of the interpolated normal with the
/// perturbed one and with the direction towards the light.
[[nodiscard]] float terminator_shadowing(float perturbation, float incidence);

/// Replaces sixteen normals by facing() of perturbed_normal(). towards_viewer: of any length but 0.
void turn_normals(const NormalVariation& variation, const TexturePoints& points, const LaneTextureAxes& axes,
                  bool back, const LaneVectors& towards_viewer, LaneVectors& normals);

}  // namespace nicol
