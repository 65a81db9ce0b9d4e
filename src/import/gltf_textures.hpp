// SPDX-License-Identifier: MIT
// The textures of a glTF file.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>

#include "import/gltf_document.hpp"
#include "import/gltf_notices.hpp"
#include "import/texture_specification.hpp"

namespace nicol::scene {

/// One use of a texture by a material.
struct GltfTextureUse {
    int index = -1;  ///< -1: none
    int texcoord_set = 0;
    const tinygltf::ExtensionMap* extensions = nullptr;
    std::string where;  ///< in the file, for messages
};
/// Returns the use that a member of a material describes. `info` must outlive it.
[[nodiscard]] inline GltfTextureUse texture_use(const auto& info, const std::string& where) {
    return {
        .index = info.index, .texcoord_set = info.texCoord, .extensions = &info.extensions, .where = where};
}

/// Returns an image one of whose channels is a number, times a factor.
[[nodiscard]] inline TextureSpecification as_number(TextureSpecification image,
                                                    TextureSpecification::Part part, double factor) {
    image.raw = true;
    image.part = part;
    image.factor = glm::dvec3(factor);
    return image;
}

/// Textures that materials use. An image in the file itself is copied once.
class GltfTextures {
public:
    /// Both must outlive this.
    GltfTextures(const GltfDocument& document, GltfNotices& notices)
        : document_(document), notices_(notices) {}

    /// Returns the image and sampling of a texture; nothing if there is no texture, or one that Nicol does
    /// not follow. Throws what read_gltf_scene() throws.
    [[nodiscard]] std::optional<TextureSpecification> read(const GltfTextureUse& use);
    /// Returns n of the TEXCOORD_n that the texture uses.
    [[nodiscard]] int texcoord_set(const GltfTextureUse& use) const;

private:
    void read_image(int index, const std::string& where, TextureSpecification& out);
    [[nodiscard]] TextureSampling sampling(int sampler, const std::string& where);
    [[nodiscard]] std::shared_ptr<const std::string> embedded(int image);

    const GltfDocument& document_;
    GltfNotices& notices_;
    std::map<int, std::shared_ptr<const std::string>> embedded_;
};

}  // namespace nicol::scene
