// SPDX-License-Identifier: MIT
#include "import/gltf_left_out.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "import/gltf_clearcoat.hpp"
#include "import/gltf_iridescence.hpp"
#include "import/gltf_transmission.hpp"

namespace nicol::scene {
namespace {

/// Extensions of a material that have an effect here.
constexpr std::array<std::string_view, 7> kFollowed = {
    kIor, "KHR_materials_emissive_strength", kAnisotropy, kTransmission, kVolume, kIridescence, kClearcoat};

/// Those among them that are followed on materials by metal and roughness alone.
constexpr std::array<std::string_view, 3> kWithMetal = {kTransmission, kVolume, kIridescence};

}  // namespace

void say_what_is_left(const tinygltf::Material& material, bool is_specular, GltfNotices& notices) {
    if (material.extensions.contains(kUnlit)) {
        notices.add(std::string(kUnlit) + ": the base colour is the radiance of a black surface, which " +
                    "lights others, too");
        return;
    }
    if (is_specular) notices.add(std::string(kSpecular) + " is followed as plastic and a mirror");
    if (material.occlusionTexture.index >= 0) notices.add("occlusion textures are not followed");
    if (material.emissiveTexture.index >= 0 ||
        std::ranges::any_of(material.emissiveFactor, [](double factor) { return factor != 0; }))
        notices.add("materials that emit light are not followed; they reflect it");
    for (const auto& [name, value] : material.extensions) {
        const bool is_followed = std::ranges::find(kFollowed, name) != kFollowed.end();
        const bool needs_metal = std::ranges::find(kWithMetal, name) != kWithMetal.end();
        if (is_specular && needs_metal)
            notices.add(name + " is not followed beside " + kSpecular);
        else if (!is_followed && !(is_specular && name == kSpecular))
            notices.add(name.substr(0, 80) + " is not followed");
    }
}

}  // namespace nicol::scene
