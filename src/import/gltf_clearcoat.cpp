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
    const auto in_unit = [&](const char* name) {
        const double value = extension.number(name, 0);
        if (!(value >= 0 && value <= 1))
            document.fail(where, std::string(name) + " is " + std::to_string(value) + "; expected 0 to 1");
        return value;
    };
    GltfClearcoat out{.factor = in_unit("clearcoatFactor"),
                      .roughness = in_unit("clearcoatRoughnessFactor"),
                      .share_texture = extension.texture("clearcoatTexture"),
                      .roughness_texture = extension.texture("clearcoatRoughnessTexture")};
    if (out.factor == 0) return out;
    if (passes) {
        notices.add(std::string(kClearcoat) + " is not followed on materials that light passes");
        out.factor = 0;
    } else if (extension.texture("clearcoatNormalTexture").index != material.normalTexture.index) {
        notices.add(std::string(kClearcoat) + ": the coat has the normals of the material below it");
    }
    return out;
}

ClearcoatModel::ClearcoatModel(MaterialDescription below, const GltfClearcoat& coat,
                               std::optional<TextureSpecification> share,
                               std::optional<TextureSpecification> roughness)
    : base(std::move(below)), factor(coat.factor), alpha(std::max(coat.roughness * coat.roughness, 0.001)) {
    using Part = TextureSpecification::Part;
    const auto of = [](TextureSpecification image, Part part, double scale) {
        image.raw = true;
        image.part = part;
        image.factor = glm::dvec3(scale);
        image.squared = part == Part::green;
        return std::make_shared<const TextureSpecification>(std::move(image));
    };
    if (share) factor.texture = of(std::move(*share), Part::red, coat.factor);
    if (roughness) alpha.texture = of(std::move(*roughness), Part::green, coat.roughness);
}

MaterialPtr ClearcoatModel::make(const MaterialMaker& maker) const {
    return clearcoat(maker.make(base), {.factor = maker.number(factor), .alpha = maker.number(alpha)});
}

}  // namespace nicol::scene
