// SPDX-License-Identifier: MIT
#include <glm/geometric.hpp>
#include <utility>

#include "arguments.hpp"
#include "texture/texture.hpp"

namespace nicol {
namespace {

glm::vec3 tint(const glm::vec3& color) {
    const float luminance = glm::dot(color, glm::vec3(0.212671F, 0.715160F, 0.072169F));
    return luminance > 0 ? color / luminance : glm::vec3(1);
}

TextureImage tinted(TextureImage image) {
    const auto channels = static_cast<std::size_t>(image.channels);
    image.values.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) *
                        channels);
    for (std::size_t i = 0; i < image.values.size(); i += channels) {
        float* const pixel = &image.values[i];
        const glm::vec3 value = tint({pixel[0], pixel[1], pixel[2]});
        for (glm::length_t c = 0; c < 3; ++c) pixel[c] = value[c];
    }
    return image;
}

}  // namespace

TexturePtr tint_texture(const TexturePtr& colors) {
    require(colors != nullptr, "the texture of a tint is null; give one");
    if (colors->channels() == 1) return constant_texture(glm::vec4(1), 1);
    const TextureDescription of = colors->describe();
    switch (of.kind) {
        case TextureDescription::Kind::constant:
            return constant_texture(glm::vec4(tint(of.colors[0]), 1), 3);
        case TextureDescription::Kind::checkerboard:
            return checkerboard_texture(tint(of.colors[0]), tint(of.colors[1]), 3, of.sampling.to_uv);
        case TextureDescription::Kind::image:
            return image_texture(tinted(of.levels.front()), of.sampling);
        default:
            throw Error(ErrorCode::unsupported,
                        "a tint of a mesh's colours; expected an image or a checkerboard");
    }
}

}  // namespace nicol
