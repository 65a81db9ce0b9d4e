// SPDX-License-Identifier: MIT
// Reflection and transmission of light by the facets of a rough boundary, after Walter et al., Microfacet
// Models for Refraction through Rough Surfaces, 2007, with a Mueller matrix in place of each Fresnel factor.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "shading/boundary_split.hpp"

namespace nicol {

// The facets of a slab are slabs themselves: what such a facet transmits goes where the facet's reflection
// would go, mirrored in the surface.

/// Returns the Mueller matrix, in 1/sr and without the cosine and the factors of the material, for light from
/// `towards_light` to `towards_viewer`: unit vectors in the surface's frame, whose z is the normal of the
/// front, on any side each. The matrix refers to the theta-phi frames of the propagation directions, as
/// Material::evaluate(). The channel matters only for a boundary with a film.
[[nodiscard]] Mueller rough_scattering(const SmoothBoundary& boundary, const glm::dvec3& towards_light,
                                       const glm::dvec3& towards_viewer, int channel = 0);

/// Returns the normal of the facets that send light from one direction to the other, on the viewer's side and
/// in the frame of rough_scattering(); zero if no facets do.
[[nodiscard]] glm::dvec3 facet_between(const SmoothBoundary& boundary, const glm::dvec3& towards_light,
                                       const glm::dvec3& towards_viewer);

/// Returns what one facet, chosen by a point in [0, 1)^2, sends to the viewer, weighted so that the mean over
/// all points is what the boundary sends. A share is 0 where other facets block the part. The other arguments
/// are those of split_at().
[[nodiscard]] BoundarySplit split_at_facet(const SmoothBoundary& boundary, const glm::dvec3& geometric,
                                           const glm::dvec3& normal, const Frame& received,
                                           const glm::dvec2& point);

}  // namespace nicol
