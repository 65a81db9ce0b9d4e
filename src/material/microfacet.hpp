// SPDX-License-Identifier: MIT
// Isotropic microfacet distributions and their shadowing, after Walter et al. 2007.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Density of facet normals at an angle from the macro normal given by its cosine, per steradian:
/// the integral of D cos over the hemisphere is 1.
[[nodiscard]] double facet_density(Distribution distribution, double alpha, double cos_facet);

/// Fraction of facets visible from a direction at that angle from the normal (Smith's G1); 0 at and below the
/// horizon. Exact for GGX; for Beckmann, Walter's rational fit, as in Mitsuba 3.
[[nodiscard]] double facet_visibility(Distribution distribution, double alpha, double cos_view);

/// D G / (4 cos cos), per steradian: reflection of facets whose normal is the half vector, without the
/// Fresnel factor. Both directions above the horizon.
[[nodiscard]] double facet_reflection(Distribution distribution, double alpha, const glm::dvec3& light,
                                      const glm::dvec3& viewer, const glm::dvec3& half);

}  // namespace nicol
