// SPDX-License-Identifier: MIT
// Plastic that depolarizes.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Mitsuba 3's `plastic` and `roughplastic`: a dielectric boundary over a diffuse base. All light that leaves
/// is unpolarized, whatever arrives; pplastic() is the model that polarizes.
struct PlasticParameters {
    ColorParameter diffuse_reflectance{0.5};   ///< 0..1
    ColorParameter specular_reflectance{1.0};  ///< 0..1
    double int_ior = 1.49;                     ///< above 0
    double ext_ior = 1.000277;                 ///< above 0
    /// Roughness, 0.001..1; 0: smooth, see Material::smooth(). A texture is moved to 0.01..1.
    NumberParameter alpha = 0.0;
    Distribution distribution = Distribution::beckmann;  ///< of a rough boundary
    /// Light that the boundary returns to the base takes the base's colour each time.
    bool nonlinear = false;
};
/// Throws as pplastic().
[[nodiscard]] MaterialPtr plastic(const PlasticParameters& parameters);

}  // namespace nicol
