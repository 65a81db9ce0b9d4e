// SPDX-License-Identifier: MIT
#include "import/gltf_clearcoat.hpp"

#include <algorithm>
#include <memory>
#include <utility>

#include "import/gltf_extension.hpp"
#include "material/clearcoat.hpp"

namespace nicol::scene {

GltfClearcoat read_clearcoat(const GltfDocument& document, const tinygltf::Material& material,
                             const std::string& where, bool passes, GltfNotices& notices) {
    const GltfExtension extension(document, material.extensions, kClearcoat, where);
    GltfClearcoat out{.factor = extension.number("clearcoatFactor", 0, 0, 1),
                      .roughness = extension.number("clearcoatRoughnessFactor", 0, 0, 1),
                      .share_texture = extension.texture("clearcoatTexture"),
                      .roughness_texture = extension.texture("clearcoatRoughnessTexture")};
    if (out.factor == 0) return {};
    if (passes) {
        notices.add(std::string(kClearcoat) + " is not followed on materials that light passes");
        return {};
    }
    if (extension.texture("clearcoatNormalTexture").index != material.normalTexture.index)
        notices.add(std::string(kClearcoat) + ": the coat has the normals of the material below it");
    return out;
}

ClearcoatModel::ClearcoatModel(MaterialDescription below, const GltfClearcoat& coat,
                               std::optional<TextureSpecification> share,
                               std::optional<TextureSpecification> roughness)
    : base(std::move(below)), factor(coat.factor), alpha(std::max(coat.roughness * coat.roughness, 0.001)) {
    using Part = TextureSpecification::Part;
    if (share)
        factor.texture = std::make_shared<const TextureSpecification>(
            as_number(std::move(*share), Part::red, coat.factor));
    if (!roughness) return;
    TextureSpecification image = as_number(std::move(*roughness), Part::green, coat.roughness);
    image.squared = true;
    alpha.texture = std::make_shared<const TextureSpecification>(std::move(image));
}

MaterialPtr ClearcoatModel::make(const MaterialMaker& maker) const {
    return clearcoat(maker.make(base), {.factor = maker.number(factor), .alpha = maker.number(alpha)});
}

}  // namespace nicol::scene
