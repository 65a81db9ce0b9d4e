// SPDX-License-Identifier: MIT
#include "material/spatial_variation.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace nicol {
namespace {

float hat(const LayerFactor& factor, float t) {
    const float end = t <= factor.middle ? factor.low : factor.high;
    if (end == factor.middle) return 1;
    if (t <= 0) return 0;
    return std::max(0.0F, (1 / end - 1 / t) / (1 / end - 1 / factor.middle));
}

template <class Needs>
bool any_texture(const SpatialVariation& variation, const Needs& needs) {
    const auto of = [&](const TexturePtr& texture) { return texture != nullptr && needs(*texture); };
    return std::ranges::any_of(variation.textures, of) || of(variation.normal.texture) ||
           of(variation.opacity);
}

}  // namespace

glm::vec3 factor_value(const LayerFactor& factor, const glm::vec4& texture) {
    switch (factor.kind) {
        case LayerFactor::Kind::value:
            return {texture};
        case LayerFactor::Kind::fraction:
            return glm::vec3(std::clamp(texture.x, 0.0F, 1.0F));
        case LayerFactor::Kind::complement:
            return glm::vec3(1 - std::clamp(texture.x, 0.0F, 1.0F));
        case LayerFactor::Kind::hat:
            break;
    }
    return glm::vec3(hat(factor, texture.x));
}

bool SpatialVariation::needs_texcoords() const {
    return normal.kind != NormalVariation::Kind::none ||
           any_texture(*this, [](const Texture& texture) { return texture.needs_texcoords(); });
}

bool SpatialVariation::needs_colors() const {
    return any_texture(*this, [](const Texture& texture) { return texture.needs_colors(); });
}

bool SpatialVariation::present(const TexturePoint& point) const {
    if (opacity == nullptr) return true;
    const glm::vec4 value = opacity->at(point);
    return (opacity->channels() == 4 ? value.w : value.x) >= 0.5F;
}

void SpatialVariation::weights(const TexturePoint& point, std::span<glm::vec3> out) const {
    std::array<glm::vec4, kMostTextures> values;
    for (std::size_t t = 0; t < textures.size(); ++t) values[t] = textures[t]->at(point);
    for (std::size_t l = 0; l < layers.size(); ++l) {
        glm::vec3 weight = layers[l].scale;
        for (const LayerFactor& factor : layers[l].factors)
            weight *= factor_value(factor, values[factor.texture]);
        out[l] = weight;
    }
}

}  // namespace nicol
