// SPDX-License-Identifier: MIT
// Clear coats over other materials.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Coat of a clear dielectric over a material.
struct ClearcoatParameters {
    NumberParameter factor = 1.0;  ///< share of the surface that has the coat, 0..1
    NumberParameter alpha =
        0.1;           ///< roughness of the coat's GGX facets, in the range of RoughConductorParameters
    double eta = 1.5;  ///< index of the coat relative to the outside, 0.01..100
};
/// Returns a material with a coat: what the facets of the coat reflect, and the material lit and seen through
/// the coat as through a smooth boundary, by Fresnel's matrices at the angles outside. Light that the coat
/// returns to the material is lost. Throws Error(invalid_argument) that names a parameter out of range, null,
/// or a material that transmits light, and what mixture() throws.
[[nodiscard]] MaterialPtr clearcoat(const MaterialPtr& material, const ClearcoatParameters& parameters);

}  // namespace nicol
