// SPDX-License-Identifier: MIT
// The textures of a scene, while it is loaded.
#pragma once

#include <filesystem>
#include <glm/vec4.hpp>
#include <map>
#include <utility>
#include <vector>

#include "import/scene_color.hpp"
#include "import/scene_files.hpp"
#include "import/texture_specification.hpp"
#include "texture/texture.hpp"

namespace nicol::scene {

/// Each image is read once, and becomes one texture for all who describe it alike.
class SceneTextures {
public:
    /// Both must outlive this.
    SceneTextures(const SceneChannels& channels, SceneFiles& files) : channels_(channels), files_(files) {}

    /// Makes the texture of a colour: one channel or RGB. Throws as reflectance() for colours that the
    /// scene's channels cannot have, and what reading the file throws.
    [[nodiscard]] TexturePtr color(const TextureSpecification& description);
    /// Makes the texture of a number: one channel, the luminance of colours. A checkerboard of numbers begins
    /// with color1, as in Mitsuba. Throws Error(unsupported) for a mesh's colours.
    [[nodiscard]] TexturePtr number(const TextureSpecification& description);
    /// Makes the texture of a normal or another vector: as color(), whatever the scene's channels.
    [[nodiscard]] TexturePtr vector(const TextureSpecification& description);
    /// Width over height of the image of a texture that one of these has made; 1 where it has none.
    [[nodiscard]] double aspect(const TextureSpecification& description) const;

private:
    enum class Use { color, number, vector };
    [[nodiscard]] TexturePtr of(const TextureSpecification& description, Use use);
    [[nodiscard]] glm::vec4 value(const ColorDescription& color, Use use) const;
    [[nodiscard]] TexturePtr made(const TextureSpecification& description, Use use);
    [[nodiscard]] const TextureImage& image(const TextureSpecification& description);

    const SceneChannels& channels_;
    SceneFiles& files_;
    /// By name, and whether raw.
    std::map<std::pair<std::filesystem::path, bool>, TextureImage> images_;
    struct Made {
        TextureSpecification description;
        Use use;
        TexturePtr texture;
    };
    std::map<std::filesystem::path, std::vector<Made>> made_;
};

}  // namespace nicol::scene
