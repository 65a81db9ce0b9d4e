// SPDX-License-Identifier: MIT
// Variation of a material over a surface (SVBRDF).
#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "material/layer_weights.hpp"
#include "material/material.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Factor of a layer's weight: a function of a texture's value t at the point.
struct LayerFactor {
    enum class Kind {
        value,       ///< t, a value for each colour
        fraction,    ///< first channel of t, clamped to 0..1
        complement,  ///< 1 - fraction
        hat,         ///< hat function of the first channel, see `low`, `middle` and `high`
        /// (1 - middle) t / (1 - middle t) for each colour: light of which the part `middle` meets the
        /// texture again each time. The factor is 1 for t = 1.
        again
    };
    Kind kind;
    std::size_t texture;  ///< index in SpatialVariation::textures
    /// Hat function, all three above 0: 1 at `middle`, 0 at and beyond `low` and `high`, linear in 1 / t
    /// between. If low (high) equals middle, the function is 1 from there on down (up).
    float low = 0, middle = 0, high = 0;

    /// Returns whether the factor has one value per colour.
    [[nodiscard]] bool colored() const noexcept { return kind == Kind::value || kind == Kind::again; }
};

/// Returns the factor of red, green and blue, or three equal ones, for the value of its texture.
[[nodiscard]] glm::vec3 factor_value(const LayerFactor& factor, const glm::vec4& texture);
/// Returns the derivative of factor_value(), by the same colour of the texture if the factor is colored(),
/// else by the first channel. The factor must not be a hat.
[[nodiscard]] glm::vec3 factor_slope(const LayerFactor& factor, const glm::vec4& texture);

/// Material that is the same everywhere, times a constant and the product of the factors.
struct MaterialLayer {
    MaterialPtr material;            ///< material without variation
    glm::vec3 scale = glm::vec3(1);  ///< red, green and blue, or three equal values
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
    /// Direction of y in a map. False: y completes a right-handed frame, as in Mitsuba. True: y points to
    /// where v falls, as in glTF, which differs if texture coordinates are mirrored.
    bool mirrored_y = false;
    /// Normal on the back of a two-sided surface. False: the front's normal mirrored in the surface, as
    /// Mitsuba's `twosided` around a map. True: the front's normal reversed, as a map around `twosided` and
    /// as glTF's doubleSided.
    bool reversed_back = false;
    /// Whether light that falls at a slant is dimmed by terminator_shadowing().
    bool shadowed = false;

    bool operator==(const NormalVariation&) const = default;
};

/// Rotation of the axes of an anisotropic material within the surface; see rotated_tangent().
struct TangentRotation {
    /// The first two of 2 t - 1 are the rotated x axis in the frame of x and y, in which y points to where v
    /// falls. Null: x.
    TexturePtr directions;
    double angle = 0;  ///< radians from x towards y, after that

    [[nodiscard]] bool any() const noexcept { return directions != nullptr || angle != 0; }
    bool operator==(const TangentRotation&) const = default;
};

/// Variation of a material: M(point, channel) = sum of weight(layer, point, channel) M_layer(channel).
struct SpatialVariation {
    static constexpr std::size_t kMostTextures = 16;

    std::vector<TexturePtr> textures;  ///< textures of the factors, each once, at most kMostTextures
    std::vector<MaterialLayer> layers;
    NormalVariation normal;
    TangentRotation rotation;
    /// Opacity: the fourth channel of a texture with four channels, else the first. Null: the surface is
    /// present everywhere.
    TexturePtr opacity;
    /// Whether an opacity between 0 and 1 is the fraction of samples and rays that the surface is present
    /// for. If not, the surface is present if the opacity is 0.5 or more.
    bool translucent = false;

    [[nodiscard]] bool needs_texcoords() const;
    [[nodiscard]] bool needs_colors(ColorsOf of) const;
    /// Returns whether weights() or the normal depends on the distance between pixels.
    [[nodiscard]] bool needs_footprint() const;

    /// Returns whether the surface is present at a point. threshold: number of 0 to 1 that a translucent
    /// surface's opacity must exceed, uniformly distributed over samples.
    [[nodiscard]] bool present(const TexturePoint& point, float threshold) const;
    /// Computes out[layer] of all layers: the weight for red, green and blue, or three equal ones.
    void weights(const TexturePoint& point, std::span<glm::vec3> out) const;
    /// Computes the weights of all layers at sixteen points.
    void weights(const TexturePoints& points, std::span<LayerWeights> out) const;
};

/// Returns whether a texture of the material needs these colours of the mesh.
[[nodiscard]] inline bool needs_colors(const Material& material, ColorsOf of) {
    const SpatialVariation* const variation = material.variation();
    return variation != nullptr && variation->needs_colors(of);
}

/// Returns whether the tangents of a mesh change how the material looks.
[[nodiscard]] inline bool follows_tangents(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    return material.anisotropic() ||
           (variation != nullptr && variation->normal.kind == NormalVariation::Kind::map);
}

/// Alpha mask of a material: the members of these names of SpatialVariation.
struct AlphaMask {
    TexturePtr opacity;  ///< null: the material is present everywhere
    bool translucent = false;

    bool operator==(const AlphaMask&) const = default;
};
[[nodiscard]] inline AlphaMask alpha_mask_of(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return {};
    return {.opacity = variation->opacity, .translucent = variation->translucent};
}

/// Returns the opacity of a material; null: the material is present everywhere.
[[nodiscard]] inline TexturePtr opacity_of(const Material& material) {
    return alpha_mask_of(material).opacity;
}

/// Returns a threshold for SpatialVariation::present() that depends on a point of a triangle, by its
/// barycentric weights, as if by chance. surface: number of the surface. Both sides of a surface have the
/// same threshold, because a ray that meets them meets one surface.
[[nodiscard]] float threshold_at(std::uint32_t surface, float b1, float b2);

/// Returns whether is(layer, term) for a term of the material or, if it varies, of one of its layers.
template <class Is>
[[nodiscard]] bool any_term(const Material& material, const Is& is) {
    if (const SpatialVariation* const variation = material.variation())
        return std::ranges::any_of(variation->layers,
                                   [&](const MaterialLayer& layer) { return any_term(*layer.material, is); });
    for (int t = 0; t < material.terms(); ++t)
        if (is(material, t)) return true;
    return false;
}

/// Returns whether a material reflects as a mirror alone, and transmits nothing.
[[nodiscard]] inline bool is_mirror(const Material& material) {
    return material.smooth_boundary() == nullptr &&
           !any_term(material, [](const Material& layer, int term) { return !layer.smooth(term); });
}

}  // namespace nicol
