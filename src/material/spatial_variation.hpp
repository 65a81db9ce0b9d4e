// SPDX-License-Identifier: MIT
// How a material varies over a surface (SVBRDF).
#pragma once

#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "material/material.hpp"
#include "material/texture.hpp"

namespace nicol {

/// A factor of a layer's weight: a function of a texture's value t at the point.
struct LayerFactor {
    enum class Kind {
        value,       ///< t, a value for each colour
        complement,  ///< 1 - t, of the first channel, within 0 and 1
        hat,         ///< of the first channel: 1 at `middle`, 0 at `low` and `high` and beyond, linear in t^2
              ///< between; low == middle (or high == middle): 1 from there on down (up)
    };
    Kind kind;
    TexturePtr texture;
    float low = 0, middle = 0, high = 0;
};

/// A material that is the same everywhere, times the product of its factors.
struct MaterialLayer {
    MaterialPtr material;  ///< without variation
    std::vector<LayerFactor> factors;
};

/// What turns the interpolated normal. Both are without effect where their texture is constant and flat.
struct NormalVariation {
    enum class Kind {
        none,
        map,  ///< 2 t - 1 is the normal in the frame of the surface: x along the direction in which u grows
        bump  ///< the surface is displaced along its normal by scale times t
    };
    Kind kind = Kind::none;
    TexturePtr texture;
    double scale = 1;
    /// map: y along the direction in which v grows, as in glTF (there -v), whatever the handedness of u and
    /// v; else y completes a right-handed frame, as in Mitsuba.
    bool mirrored_y = false;
};

/// M(point, channel) = sum of layers, weight(layer, point, channel) M_layer(channel).
struct SpatialVariation {
    std::vector<MaterialLayer> layers;
    NormalVariation normal;
    /// The fourth channel (of four) or the first: the surface is there where it is 0.5 or more. Null:
    /// everywhere.
    TexturePtr opacity;

    [[nodiscard]] bool needs_texcoords() const;
    [[nodiscard]] bool needs_colors() const;

    /// out[layer]: its weight for red, green and blue, or three equal ones.
    void weights(const TexturePoint& point, std::span<glm::vec3> out) const;
};

}  // namespace nicol
