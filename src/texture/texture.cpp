// SPDX-License-Identifier: MIT
#include "texture/texture.hpp"

namespace nicol {

TexturePoint texture_point(const glm::vec3& weights, const std::array<glm::vec2, 3>* texcoords,
                           const std::array<glm::vec3, 3>* colors) {
    const auto at = [&](const auto& corners) {
        return weights.x * corners[0] + weights.y * corners[1] + weights.z * corners[2];
    };
    TexturePoint point;
    if (texcoords != nullptr) point.uv = at(*texcoords);
    if (colors != nullptr) point.color = at(*colors);
    return point;
}

void Texture::at_lanes(const TexturePoints& points, std::array<Lanes, 4>& out) const {
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec4 value = at(points.at(i));
        for (glm::length_t c = 0; c < 4; ++c) out[static_cast<std::size_t>(c)][i] = value[c];
    }
}

}  // namespace nicol
