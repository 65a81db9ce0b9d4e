// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>

#include "arguments.hpp"
#include "texture/mapped_texture.hpp"

namespace nicol {
namespace {

glm::vec3 tint(const glm::vec3& color) {
    const float luminance = glm::dot(color, glm::vec3(0.212671F, 0.715160F, 0.072169F));
    return luminance > 0 ? color / luminance : glm::vec3(1);
}

}  // namespace

TexturePtr tint_texture(const TexturePtr& colors) {
    require(colors != nullptr, "the texture of a tint is null; give one");
    if (colors->channels() == 1) return constant_texture(glm::vec4(1), 1);
    return mapped_texture(*colors, 3, tint, "a tint of a mesh's colours");
}

}  // namespace nicol
