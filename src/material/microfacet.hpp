// SPDX-License-Identifier: MIT
// Microfacet distributions and their shadowing, after Walter et al. 2007; of anisotropic ones after Heitz
// 2014.
#pragma once

#include <glm/vec2.hpp>

#include "material/material.hpp"

namespace nicol {

/// Density of facet normals at an angle from the macro normal given by its cosine, per steradian:
/// the integral of D cos over the hemisphere is 1.
[[nodiscard]] double facet_density(Distribution distribution, double alpha, double cos_facet);
/// The same of facets with a roughness along x and one along y, at a unit normal in that frame.
[[nodiscard]] double facet_density(Distribution distribution, const glm::dvec2& alpha,
                                   const glm::dvec3& facet);

/// Fraction of facets visible from a direction at that angle from the normal (Smith's G1); 0 at and below the
/// horizon. Exact for GGX; for Beckmann, Walter's rational fit, as in Mitsuba 3.
[[nodiscard]] double facet_visibility(Distribution distribution, double alpha, double cos_view);
/// The same from a unit direction: that of the roughness along its azimuth.
[[nodiscard]] double facet_visibility(Distribution distribution, const glm::dvec2& alpha,
                                      const glm::dvec3& view);

/// D G / (4 cos cos), per steradian: reflection of facets whose normal is the half vector, without the
/// Fresnel factor. Both directions above the horizon.
[[nodiscard]] double facet_reflection(Distribution distribution, double alpha, const glm::dvec3& light,
                                      const glm::dvec3& viewer, const glm::dvec3& half);
[[nodiscard]] double facet_reflection(Distribution distribution, const glm::dvec2& alpha,
                                      const glm::dvec3& light, const glm::dvec3& viewer,
                                      const glm::dvec3& half);

}  // namespace nicol
