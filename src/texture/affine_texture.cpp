// SPDX-License-Identifier: MIT
#include "texture/affine_texture.hpp"

#include <algorithm>

#include "arguments.hpp"
#include "texture/mapped_texture.hpp"

namespace nicol {

TexturePtr affine_texture(const TexturePtr& texture, float factor, float offset) {
    require(texture != nullptr, "the texture of a number is null; give one");
    return mapped_texture(
        *texture, 1,
        [&](const glm::vec3& t) { return glm::vec3(factor * std::clamp(t.x, 0.0F, 1.0F) + offset); },
        "a mesh's colours where a number varies");
}

}  // namespace nicol
