// SPDX-License-Identifier: MIT
// Disney's material.
#pragma once

#include "material/material.hpp"

namespace nicol {

/// Mitsuba 3's `principled`, without what it transmits: Burley's lobes (principled_lobes.hpp), which
/// depolarize. All but base_color and eta are numbers of 0 to 1. Textures of these are moved to 0..1, of
/// roughness, anisotropic and clearcoat_gloss as with_number() does it.
struct PrincipledParameters {
    ColorParameter base_color{0.5};   ///< 0..1
    NumberParameter roughness = 0.5;  ///< GGX facets have alpha = roughness^2
    /// Facets have alpha / sqrt(1 - 0.9 anisotropic) along x and alpha sqrt(1 - 0.9 anisotropic) along y.
    NumberParameter anisotropic = 0.0;
    NumberParameter metallic = 0.0;
    NumberParameter spec_trans = 0.0;  ///< the share of the diffuse base that lets light through in its place
    /// Relative index of the facets, 0.001..1000; 1: there are none, not even of a metal, as in Mitsuba. For
    /// Disney's `specular` it is 2 / (1 - sqrt(0.08 specular)) - 1.
    double eta = 1.5;
    NumberParameter spec_tint = 0.0;  ///< from Fresnel's reflection to Schlick's in the tint of the base
    NumberParameter sheen = 0.0;
    NumberParameter sheen_tint = 0.0;  ///< from white to the tint of the base
    NumberParameter flatness = 0.0;    ///< from the diffuse base to one like subsurface scattering
    NumberParameter clearcoat = 0.0;
    NumberParameter clearcoat_gloss = 0.0;
};

/// The tint of a base is its colour over its luminance, which is BT.709's of three channels and else their
/// mean; that of black is white. Throws as pplastic(), and what tint_texture() throws.
[[nodiscard]] MaterialPtr principled(const PrincipledParameters& parameters);

/// The index for Disney's `specular`, 0 to 1.
[[nodiscard]] double index_of_specular(double specular);

}  // namespace nicol
