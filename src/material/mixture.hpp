// SPDX-License-Identifier: MIT
// Materials composed of other materials and textures. The values of such a material are its mean over the
// textures, and Material::variation() describes how it varies. Textures with one value become constants, so a
// material that varies nowhere has no variation.
#pragma once

#include <functional>

#include "material/material.hpp"
#include "material/spatial_variation.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// All functions throw Error(invalid_argument) that names what is wrong: null, channels that do not fit, or
/// parts that differ in normals, in the rotation of anisotropic parts or in opacity.

/// Returns the mixture that a variation describes: the sum of its layers, each times its weight.
[[nodiscard]] MaterialPtr mixture(SpatialVariation variation);

/// Returns the material times a texture.
[[nodiscard]] MaterialPtr scaled(const MaterialPtr& material, const TexturePtr& scale);
/// Returns the material times a factor of a texture, of any kind but hat and again.
[[nodiscard]] MaterialPtr scaled_by(LayerFactor::Kind kind, const MaterialPtr& material,
                                    const TexturePtr& scale);
/// Returns the material times (1 - again) t / (1 - again t) for a texture's value t: light of which the part
/// `again`, 0 to 0.999, meets the texture again each time. The factor is 1 for t = 1.
[[nodiscard]] MaterialPtr scaled_again(const MaterialPtr& material, const TexturePtr& scale, double again);
/// Returns the sum of two materials.
[[nodiscard]] MaterialPtr sum(const MaterialPtr& first, const MaterialPtr& second);
/// Returns first (1 - t) + second t; t: first channel of a texture, clamped to 0..1 (Mitsuba's blendbsdf).
[[nodiscard]] MaterialPtr blend(const MaterialPtr& first, const MaterialPtr& second,
                                const TexturePtr& weight);
/// Returns make(t) for a texture's first channel t, clamped to least..1 with least above 0. Interpolates
/// linearly in 1 / t between texture_numbers(); exact for a texture of up to 16 values.
[[nodiscard]] MaterialPtr with_number(const std::function<MaterialPtr(double t)>& make,
                                      const TexturePtr& texture, double least, double ratio);
/// Returns with_number() for a roughness alpha, clamped to 0.01..1, with a ratio of 1.2.
[[nodiscard]] MaterialPtr with_roughness(const std::function<MaterialPtr(double alpha)>& make,
                                         const TexturePtr& alpha);
/// Returns make(alpha_u, alpha_v) with both from textures: exact for textures of up to 8 values each, and
/// interpolated between up to 8 values of each for others.
[[nodiscard]] MaterialPtr with_roughness(const std::function<MaterialPtr(double u, double v)>& make,
                                         const TexturePtr& alpha_u, const TexturePtr& alpha_v);

/// Members of NormalVariation that a map of normals or heights leaves open. `reversed_back` is true in any
/// case if the material is two-sided already.
struct MapOptions {
    bool mirrored_y = false;  ///< maps of normals only
    bool reversed_back = false;
    bool shadowed = false;
};
/// Returns the material with normals from a texture.
[[nodiscard]] MaterialPtr normal_mapped(MaterialPtr material, TexturePtr normals,
                                        const MapOptions& options = {});
[[nodiscard]] MaterialPtr bump_mapped(MaterialPtr material, TexturePtr heights, double scale,
                                      const MapOptions& options = {});

/// Returns the material with the axes of its anisotropic parts rotated within the surface. directions: see
/// TangentRotation; null: none. angle: in radians.
[[nodiscard]] MaterialPtr rotated(const MaterialPtr& material, TexturePtr directions, double angle);

/// Returns the material cut out where the opacity is below 0.5. `translucent` is explained at
/// SpatialVariation.
[[nodiscard]] MaterialPtr masked(MaterialPtr material, TexturePtr opacity, bool translucent = false);

}  // namespace nicol
