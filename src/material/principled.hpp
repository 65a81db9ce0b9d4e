// SPDX-License-Identifier: MIT
// Disney's material.
#pragma once

#include <vector>

#include "material/material.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Mitsuba 3's `principled`, without what it transmits: Burley's lobes (principled_lobes.hpp), which
/// depolarize. All but base_color and eta are numbers of 0 to 1.
struct PrincipledParameters {
    std::vector<double> base_color{0.5};  ///< 0..1, one value or one a channel
    double roughness = 0.5;               ///< GGX facets have alpha = roughness^2
    /// Facets have alpha / sqrt(1 - 0.9 anisotropic) along x and alpha sqrt(1 - 0.9 anisotropic) along y.
    double anisotropic = 0;
    double metallic = 0;
    double spec_trans = 0;  ///< the share of the diffuse base that lets light through in its place
    /// Relative index of the facets, 0.001..1000; 1: there are none, not even of a metal, as in Mitsuba. For
    /// Disney's `specular` it is 2 / (1 - sqrt(0.08 specular)) - 1.
    double eta = 1.5;
    double spec_tint = 0;  ///< from Fresnel's reflection to Schlick's in the tint of the base
    double sheen = 0;
    double sheen_tint = 0;  ///< from white to the tint of the base
    double flatness = 0;    ///< from the diffuse base to one like subsurface scattering
    double clearcoat = 0;
    double clearcoat_gloss = 0;
};

/// Each replaces the number of its name; null: the number holds. base_color takes the texture's colours, the
/// others its first channel, moved to 0..1; roughness, anisotropic and clearcoat_gloss as with_number() does.
struct PrincipledTextures {
    TexturePtr base_color, roughness, anisotropic, metallic, spec_trans, spec_tint, sheen, sheen_tint,
        flatness, clearcoat, clearcoat_gloss;
};

/// The tint of a base is its colour over its luminance, which is BT.709's of three channels and else their
/// mean; that of black is white. Throws Error(invalid_argument) naming the parameter that is out of range,
/// and what the functions of layered.hpp and tint_texture() throw.
[[nodiscard]] MaterialPtr principled(const PrincipledParameters& parameters,
                                     const PrincipledTextures& textures = {});

/// The index for Disney's `specular`, 0 to 1.
[[nodiscard]] double index_of_specular(double specular);

}  // namespace nicol
