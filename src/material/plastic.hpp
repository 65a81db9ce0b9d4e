// SPDX-License-Identifier: MIT
// Depolarizing plastic.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Parameters of Mitsuba 3's `plastic` and `roughplastic`: a dielectric boundary over a diffuse base. All
/// reflected light is unpolarized; pplastic() is the model that polarizes.
struct PlasticParameters {
    ColorParameter diffuse_reflectance{0.5};   ///< 0..1
    ColorParameter specular_reflectance{1.0};  ///< 0..1
    double int_ior = 1.49;                     ///< index of the inside, 0.001..1000
    double ext_ior = 1.000277;                 ///< index of the outside, 0.001..1000
    /// Roughness, 0.001..1, or 0 for a smooth surface (Material::smooth()). A texture is clamped to 0.01..1.
    NumberParameter alpha = 0.0;
    Distribution distribution = Distribution::beckmann;  ///< facets of a rough boundary
    /// True: light that the boundary returns to the base takes the base's colour each time.
    bool nonlinear = false;
};
/// Returns the material. Throws what pplastic() throws.
[[nodiscard]] MaterialPtr plastic(const PlasticParameters& parameters);

}  // namespace nicol
