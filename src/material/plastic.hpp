// SPDX-License-Identifier: MIT
// Plastic that depolarizes.
#pragma once

#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Mitsuba 3's `plastic` and `roughplastic`: a dielectric boundary over a diffuse base. All light that leaves
/// is unpolarized, whatever arrives; pplastic() is the model that polarizes.
struct PlasticParameters {
    std::vector<double> diffuse_reflectance{0.5};   ///< 0..1, one value or one a channel
    std::vector<double> specular_reflectance{1.0};  ///< 0..1, one value or one a channel
    double int_ior = 1.49;                          ///< above 0
    double ext_ior = 1.000277;                      ///< above 0
    double alpha = 0;  ///< roughness, 0.001..1; 0: smooth, see Material::smooth()
    Distribution distribution = Distribution::beckmann;  ///< of a rough boundary
    /// Light that the boundary returns to the base takes the base's colour each time.
    bool nonlinear = false;
};
/// Throws Error(invalid_argument) naming the parameter that is out of range.
[[nodiscard]] MaterialPtr plastic(const PlasticParameters& parameters);

}  // namespace nicol
