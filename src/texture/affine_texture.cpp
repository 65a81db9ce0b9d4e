// SPDX-License-Identifier: MIT
#include "texture/affine_texture.hpp"

#include <algorithm>
#include <utility>

#include "arguments.hpp"

namespace nicol {

TexturePtr affine_texture(const TexturePtr& texture, float factor, float offset) {
    require(texture != nullptr, "the texture of a number is null; give one");
    const auto of = [&](float t) { return factor * std::clamp(t, 0.0F, 1.0F) + offset; };
    const TextureDescription from = texture->describe();
    const auto color = [&](std::size_t i) { return glm::vec3(of(from.colors[i].x)); };
    switch (from.kind) {
        case TextureDescription::Kind::constant:
            return constant_texture(glm::vec4(color(0), 1), 1);
        case TextureDescription::Kind::checkerboard:
            return checkerboard_texture(color(0), color(1), 1, from.sampling.to_uv);
        case TextureDescription::Kind::image: {
            const TextureImage& colors = from.levels.front();
            TextureImage numbers{.width = colors.width, .height = colors.height, .channels = 1, .values = {}};
            numbers.values.resize(static_cast<std::size_t>(colors.width) *
                                  static_cast<std::size_t>(colors.height));
            const auto channels = static_cast<std::size_t>(colors.channels);
            for (std::size_t i = 0; i < numbers.values.size(); ++i)
                numbers.values[i] = of(colors.values[channels * i]);
            return image_texture(std::move(numbers), from.sampling);
        }
        default:
            throw Error(ErrorCode::unsupported,
                        "a mesh's colours where a number varies; expected an image or a checkerboard");
    }
}

}  // namespace nicol
