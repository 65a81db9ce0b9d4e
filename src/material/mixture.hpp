// SPDX-License-Identifier: MIT
// Materials made of others and textures. Each is a Material whose own values are its mean over the textures;
// how it varies is Material::variation(). Textures of one value fold away: what varies nowhere has no
// variation.
#pragma once

#include <functional>

#include "material/material.hpp"
#include "material/spatial_variation.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// All throw Error(invalid_argument), naming what is wrong: a null, channels that do not fit, parts that are
/// not two-sided alike, or turn their normals by different textures.

/// The material that a variation describes.
[[nodiscard]] MaterialPtr layered(SpatialVariation variation);

/// The material times a texture.
[[nodiscard]] MaterialPtr scaled(const MaterialPtr& material, const TexturePtr& scale);
/// The material times what any kind but hat and again makes of a texture.
[[nodiscard]] MaterialPtr scaled_by(LayerFactor::Kind kind, const MaterialPtr& material,
                                    const TexturePtr& scale);
/// The same for light of which the part `again`, 0 to 0.999, meets the texture again each time: times
/// (1 - again) t / (1 - again t), which is 1 where the texture's value t is.
[[nodiscard]] MaterialPtr scaled_again(const MaterialPtr& material, const TexturePtr& scale, double again);
/// Both together.
[[nodiscard]] MaterialPtr sum(const MaterialPtr& first, const MaterialPtr& second);
/// first (1 - t) + second t, t the first channel of a texture, moved to 0..1 (Mitsuba's blendbsdf).
[[nodiscard]] MaterialPtr blend(const MaterialPtr& first, const MaterialPtr& second,
                                const TexturePtr& weight);
/// make(t) with t from the first channel of a texture, moved to least..1, least above 0: an interpolation,
/// linear in 1 / t, between values whose ratio is at most `ratio`; exact for a texture of up to 16 values.
[[nodiscard]] MaterialPtr with_number(const std::function<MaterialPtr(double t)>& make,
                                      const TexturePtr& texture, double least, double ratio);
/// The same of a roughness alpha, moved to 0.01..1, between values that differ by a fifth at most.
[[nodiscard]] MaterialPtr with_roughness(const std::function<MaterialPtr(double alpha)>& make,
                                         const TexturePtr& alpha);
/// make(alpha_u, alpha_v) with both from textures; exact for textures of up to 8 values, and between that
/// many of each for others.
[[nodiscard]] MaterialPtr with_roughness(const std::function<MaterialPtr(double u, double v)>& make,
                                         const TexturePtr& alpha_u, const TexturePtr& alpha_v);

/// Normals from a texture, see NormalVariation. `mirrored_y`: there.
[[nodiscard]] MaterialPtr normal_mapped(MaterialPtr material, TexturePtr normals, bool mirrored_y = false);
[[nodiscard]] MaterialPtr bump_mapped(MaterialPtr material, TexturePtr heights, double scale);

/// Cut out where the opacity is below 0.5.
[[nodiscard]] MaterialPtr masked(MaterialPtr material, TexturePtr opacity);

}  // namespace nicol
