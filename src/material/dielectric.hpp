// SPDX-License-Identifier: MIT
// Smooth glass: materials that transmit light.
#pragma once

#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Smooth boundary that splits light into a reflected and a transmitted part by Fresnel's formulas.
struct SmoothBoundary {
    /// Medium behind the front of the surface.
    enum class Behind {
        body,  ///< a body: the transmitted light is refracted
        slab,  ///< a thin slab and then the outside again: the transmitted light goes straight on
    };
    Behind behind = Behind::body;
    double eta = 1;                          ///< index of the inside relative to the outside
    std::vector<double> reflectance{1.0};    ///< factor of reflected light, one value or one per channel
    std::vector<double> transmittance{1.0};  ///< factor of transmitted light, as `reflectance`
};

/// Parameters of Mitsuba 3's `dielectric` and `thindielectric`.
struct DielectricParameters {
    ColorParameter specular_reflectance{1.0};    ///< 0..1
    ColorParameter specular_transmittance{1.0};  ///< 0..1
    double int_ior = 1.5046;                     ///< index of the inside, 0.001..1000
    double ext_ior = 1.000277;                   ///< index of the outside, 0.001..1000
};
/// Returns the boundary between the inside of a body and the outside. Throws Error(invalid_argument) that
/// names the parameter out of range, and Error(unsupported) for a texture.
[[nodiscard]] MaterialPtr dielectric(const DielectricParameters& parameters);
/// Returns a slab so thin that light leaves it where it arrives. All reflections inside the slab are summed
/// without interference. Throws what dielectric() throws.
[[nodiscard]] MaterialPtr thin_dielectric(const DielectricParameters& parameters);

}  // namespace nicol
