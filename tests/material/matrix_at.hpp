// SPDX-License-Identifier: MIT
// The Mueller matrix of a material at a surface point.
#pragma once

#include "material/spatial_variation.hpp"

namespace nicol::test {

/// Returns M of a channel at texture coordinates, by definition.
inline Mueller matrix_at(const Material& material, int channel, glm::vec2 uv, const glm::dvec3& light,
                         const glm::dvec3& viewer) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return evaluate(material, channel, light, viewer);
    std::vector<glm::vec3> weights(variation->layers.size());
    variation->weights({.uv = uv}, weights);
    Mueller sum;
    for (std::size_t l = 0; l < weights.size(); ++l) {
        const Material& layer = *variation->layers[l].material;
        sum = sum + static_cast<double>(weights[l][channel]) *
                        evaluate(layer, layer.channels() == 1 ? 0 : channel, light, viewer);
    }
    return sum;
}

}  // namespace nicol::test
