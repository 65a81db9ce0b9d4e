// SPDX-License-Identifier: MIT
// Disney's principled material.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Parameters of Mitsuba 3's `principled`: Burley's lobes (principled_lobes.hpp), which depolarize, and
/// facets that transmit light as those of rough glass, which polarize. All but base_color and eta are numbers
/// of 0 to 1. Textures are clamped to 0..1, or as in with_number() for roughness, anisotropic and
/// clearcoat_gloss.
struct PrincipledParameters {
    ColorParameter base_color{0.5};   ///< 0..1
    NumberParameter roughness = 0.5;  ///< GGX facets have alpha = roughness^2
    /// Facets have alpha / sqrt(1 - 0.9 anisotropic) along x and alpha sqrt(1 - 0.9 anisotropic) along y.
    NumberParameter anisotropic = 0.0;
    NumberParameter metallic = 0.0;
    /// Share of the diffuse base that transmits light instead, times the square root of base_color. What is
    /// transmitted depends on the means of textures.
    NumberParameter spec_trans = 0.0;
    bool transmits = true;  ///< false: what would pass the surface is left out
    /// Relative index of the facets, 0.001..1000; 1: there are no facets, not even of a metal, as in Mitsuba.
    /// index_of_specular() computes eta for Disney's `specular`.
    double eta = 1.5;
    NumberParameter spec_tint = 0.0;  ///< 0: Fresnel's reflection; 1: Schlick's in the tint of the base
    NumberParameter sheen = 0.0;
    NumberParameter sheen_tint = 0.0;  ///< 0: white; 1: tint of the base
    NumberParameter flatness = 0.0;    ///< 0: diffuse base; 1: base like subsurface scattering
    NumberParameter clearcoat = 0.0;
    NumberParameter clearcoat_gloss = 0.0;
};

/// Returns the material; light passes it if spec_trans is above 0, see transmitting(). The tint of a base is
/// its colour over its luminance: BT.709's for three channels, else the mean. The tint of black is white.
/// Throws what pplastic() and tint_texture() throw.
[[nodiscard]] MaterialPtr principled(const PrincipledParameters& parameters);

/// Parameters of Mitsuba 3's `principledthin`: a sheet that reflects and transmits like two boundaries, as a
/// slab of dielectric(), beside a diffuse base. Only the front reflects.
struct PrincipledThinParameters {
    ColorParameter base_color{0.5};    ///< 0..1
    NumberParameter roughness = 0.5;   ///< GGX facets have alpha = roughness^2
    NumberParameter spec_trans = 0.0;  ///< share of the base that the facets replace; its mean if a texture
    double eta = 1.5;                  ///< relative index of the facets, 0.001..1000
    NumberParameter sheen = 0.0;
    NumberParameter sheen_tint = 0.0;
    NumberParameter flatness = 0.0;
    double diff_trans = 0;  ///< twice the share of diffuse light that the base does not reflect, 0..2
};
/// Returns the material. Throws what principled() throws.
[[nodiscard]] MaterialPtr principled_thin(const PrincipledThinParameters& parameters);

/// Returns eta for Disney's `specular`, 0 to 1: 2 / (1 - sqrt(0.08 specular)) - 1.
[[nodiscard]] double index_of_specular(double specular);

}  // namespace nicol
