// SPDX-License-Identifier: MIT
// Textures whose values are functions of another texture's values.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <string>
#include <utility>

#include "error.hpp"
#include "texture/texture.hpp"

namespace nicol {

/// Returns the texture of of(colour) for each colour of a constant texture, a checkerboard or an image.
/// channels: 1, of the first number, or 3; an image of four channels then keeps its coverage. what: the
/// texture in the message of Error(unsupported), which is thrown for colours of a mesh, alone or as a factor.
template <class Of>
[[nodiscard]] TexturePtr mapped_texture(const Texture& texture, int channels, const Of& of,
                                        const std::string& what) {
    const TextureDescription from = texture.describe();
    switch (from.kind) {
        case TextureDescription::Kind::constant:
            return constant_texture(glm::vec4(of(glm::vec3(from.colors[0])), 1), channels);
        case TextureDescription::Kind::checkerboard:
            return checkerboard_texture(of(glm::vec3(from.colors[0])), of(glm::vec3(from.colors[1])),
                                        channels, from.sampling.to_uv);
        case TextureDescription::Kind::image: {
            const TextureImage& image = from.levels.front();
            TextureImage out{.width = image.width,
                             .height = image.height,
                             .channels = channels == 1 ? 1 : image.channels,
                             .values = {}};
            const auto step = static_cast<std::size_t>(image.channels);
            const std::size_t values =
                static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * step;
            out.values.reserve(values / step * static_cast<std::size_t>(out.channels) + 1);
            for (std::size_t i = 0; i < values; i += step) {
                const float* const pixel = &image.values[i];
                const glm::vec3 value =
                    of(step == 1 ? glm::vec3(pixel[0]) : glm::vec3(pixel[0], pixel[1], pixel[2]));
                for (glm::length_t c = 0; c < channels; ++c) out.values.push_back(value[c]);
                if (out.channels == 4) out.values.push_back(pixel[3]);
            }
            return image_texture(std::move(out), from.sampling);
        }
        default:
            throw Error(ErrorCode::unsupported, what + "; expected an image or a checkerboard");
    }
}

}  // namespace nicol
