// SPDX-License-Identifier: MIT
// Textures as words and texels for shaders.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "texture/texture.hpp"

namespace nicol {

/// List of textures in the layout of glsl/texture.glsl. A texture's factors precede it.
class TextureTable {
public:
    /// Words of one texture.
    static constexpr std::size_t kWords = 24;

    /// Returns the number of a texture, which is added unless it is in the list.
    std::uint32_t number_of(const TexturePtr& texture);
    [[nodiscard]] std::size_t count() const noexcept { return textures_.size(); }
    /// Returns the number of values of all texels.
    [[nodiscard]] std::size_t texels() const;

    /// Appends the textures' words, which begin at `begin`, and their texels.
    void write(std::size_t begin, std::vector<std::uint32_t>& table, std::vector<float>& texels) const;

private:
    std::vector<TexturePtr> textures_;
    std::vector<TextureDescription> descriptions_;
    std::vector<std::array<std::uint32_t, 2>> factors_;
};

}  // namespace nicol
