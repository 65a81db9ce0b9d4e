// SPDX-License-Identifier: MIT
// Reflectance models whose parameters are textures.
#pragma once

#include "material/conductor.hpp"
#include "material/material.hpp"
#include "material/plastic.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Each replaces the number of its name; null: the number holds. Reflectances take the texture's colours,
/// which are meant to lie in 0..1 but may exceed it; alpha takes its first channel, moved to 0.01..1.
struct PlasticTextures {
    TexturePtr diffuse_reflectance;
    TexturePtr specular_reflectance;
    TexturePtr alpha;
};
/// Throws as pplastic() and as the functions of layered.hpp.
[[nodiscard]] MaterialPtr pplastic(const PplasticParameters& parameters, const PlasticTextures& textures);

/// Throws as plastic() and as the functions of layered.hpp.
[[nodiscard]] MaterialPtr plastic(const PlasticParameters& parameters, const PlasticTextures& textures);

struct ConductorTextures {
    TexturePtr specular_reflectance;
    TexturePtr alpha;
    TexturePtr alpha_v;  ///< null, and alpha_v is 0: alpha is for both directions
};
[[nodiscard]] MaterialPtr rough_conductor(const RoughConductorParameters& parameters,
                                          const ConductorTextures& textures);

}  // namespace nicol
