// SPDX-License-Identifier: MIT
// How a material varies over a surface (SVBRDF).
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "material/material.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// A factor of a layer's weight: a function of a texture's value t at the point.
struct LayerFactor {
    enum class Kind {
        value,       ///< t, a value for each colour
        fraction,    ///< the first channel of t, moved to 0..1
        complement,  ///< 1 - fraction
        hat,         ///< of the first channel, see below
        /// (1 - middle) t / (1 - middle t) for each colour: t for light that meets the texture again and
        /// again, the part `middle` of it each time. 1 where t is 1.
        again
    };
    Kind kind;
    std::size_t texture;  ///< of SpatialVariation::textures
    /// hat: 1 at `middle`, 0 at `low` and `high` and beyond, linear in 1 / t between; all above 0. Where low
    /// (high) equals middle: 1 from there on down (up).
    float low = 0, middle = 0, high = 0;

    /// Whether it is one for each colour.
    [[nodiscard]] bool colored() const noexcept { return kind == Kind::value || kind == Kind::again; }
};

/// Of red, green and blue, or three equal ones, for the value of its texture.
[[nodiscard]] glm::vec3 factor_value(const LayerFactor& factor, const glm::vec4& texture);

/// A material that is the same everywhere, times a constant and the product of its factors.
struct MaterialLayer {
    MaterialPtr material;            ///< without variation
    glm::vec3 scale = glm::vec3(1);  ///< of red, green and blue, or three equal ones
    std::vector<LayerFactor> factors = {};
};

/// Perturbation of the interpolated normal; see perturbed_normal().
struct NormalVariation {
    enum class Kind {
        none,
        map,  ///< 2 t - 1 is the normal in the surface's frame, x along the direction in which u grows
        bump  ///< the surface is displaced along its normal by scale times t
    };
    Kind kind = Kind::none;
    TexturePtr texture;
    double scale = 1;
    /// map: false: y completes a right-handed frame, as in Mitsuba. True: y points to where v falls, which
    /// differs where texture coordinates are mirrored, as in glTF.
    bool mirrored_y = false;

    bool operator==(const NormalVariation&) const = default;
};

/// M(point, channel) = sum of layers, weight(layer, point, channel) M_layer(channel).
struct SpatialVariation {
    static constexpr std::size_t kMostTextures = 16;

    std::vector<TexturePtr> textures;  ///< of the factors, each once, at most kMostTextures
    std::vector<MaterialLayer> layers;
    NormalVariation normal;
    /// The fourth channel (of four) or the first: the surface is there where it is 0.5 or more. Null:
    /// everywhere.
    TexturePtr opacity;

    [[nodiscard]] bool needs_texcoords() const;
    [[nodiscard]] bool needs_colors(ColorsOf of) const;
    /// Of what weights() and normal look at.
    [[nodiscard]] bool needs_footprint() const;

    /// Whether the surface is there.
    [[nodiscard]] bool present(const TexturePoint& point) const;
    /// out[layer], of all layers: its weight for red, green and blue, or three equal ones.
    void weights(const TexturePoint& point, std::span<glm::vec3> out) const;
    /// The same of sixteen points.
    void weights(const TexturePoints& points, std::span<LayerWeights> out) const;
};

/// Whether a texture of the material is of these colours of the mesh.
[[nodiscard]] inline bool needs_colors(const Material& material, ColorsOf of) {
    const SpatialVariation* const variation = material.variation();
    return variation != nullptr && variation->needs_colors(of);
}

/// Null for a material that is there everywhere.
[[nodiscard]] inline TexturePtr opacity_of(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    return variation != nullptr ? variation->opacity : nullptr;
}

}  // namespace nicol
