// SPDX-License-Identifier: MIT
// The textures of a scene, while it is loaded.
#pragma once

#include <filesystem>
#include <glm/vec4.hpp>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "import/scene_color.hpp"
#include "import/scene_files.hpp"
#include "import/texture_specification.hpp"
#include "texture/image_pixels.hpp"
#include "texture/texture.hpp"

namespace nicol::scene {

/// Textures of a scene. Each image is read once and becomes one texture for all equal descriptions.
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
    /// Makes the texture of a number that Mitsuba reads as a colour: as number(), but a checkerboard begins
    /// with color0.
    [[nodiscard]] TexturePtr number_of_color(const TextureSpecification& description);
    /// Returns whether number() or number_of_color(), which was called before, has united different values of
    /// red, green and blue.
    [[nodiscard]] bool colored(const TextureSpecification& description);
    /// Makes the texture of a normal or another vector: as color(), whatever the scene's channels.
    [[nodiscard]] TexturePtr vector(const TextureSpecification& description);

    /// Textures of a shape that take the place of its attributes, by the attributes' whole names.
    using Attributes = std::map<std::string, TextureSpecificationPtr>;
    /// Sets the shape whose material is made next. Null: no shape has textures in the place of attributes.
    void set_attributes(const Attributes* attributes) { attributes_ = attributes; }
    /// Attribute of a mesh that a texture needs.
    struct NeededAttribute {
        ColorsOf of;
        std::string name;  ///< see MeshColorNames
        bool number;       ///< whether it must have one number
        // NOLINTNEXTLINE(modernize-use-nullptr): the zero is the comparison's own
        auto operator<=>(const NeededAttribute&) const = default;
    };
    /// Returns the attributes that textures have needed since the last call.
    [[nodiscard]] std::set<NeededAttribute> take_needed() { return std::exchange(needed_, {}); }

    /// Returns width over height of the image of a texture that this has made; 1 if the texture has no image.
    [[nodiscard]] double aspect(const TextureSpecification& description) const;

private:
    enum class Use { color, number, vector };
    [[nodiscard]] TexturePtr of(const TextureSpecification& description, Use use);
    // Returns the texture of the shape that stands in the place of the attribute that a texture has as a
    // factor; null if there is none.
    [[nodiscard]] const TextureSpecification* in_place_of_attribute(
        const TextureSpecification& description) const;
    void need_attribute(const TextureSpecification& description, Use use);
    // Throws Error(unsupported) unless the scene's channels are red, green and blue.
    void require_rgb(const char* what) const;
    [[nodiscard]] glm::vec4 value(const ColorDescription& color, Use use) const;
    [[nodiscard]] TexturePtr made(const TextureSpecification& description, Use use);
    [[nodiscard]] const ImagePixels& image(const TextureSpecification& description);

    const SceneChannels& channels_;
    SceneFiles& files_;
    /// Images by name, and by whether they are raw.
    std::map<std::pair<std::filesystem::path, bool>, ImagePixels> images_;
    struct Made {
        TextureSpecification description;
        Use use;
        TexturePtr texture;
    };
    std::map<std::filesystem::path, std::vector<Made>> made_;
    const Attributes* attributes_ = nullptr;
    std::set<NeededAttribute> needed_;
};

}  // namespace nicol::scene
