// SPDX-License-Identifier: MIT
// Materials.
#include <algorithm>
#include <array>
#include <cmath>

#include "scene/gltf_readers.hpp"

namespace nicol::scene {
namespace {

/// Those of a material that have an effect here.
constexpr std::array<std::string_view, 2> kFollowed = {"KHR_materials_ior",
                                                       "KHR_materials_emissive_strength"};

class GltfMaterial {
public:
    GltfMaterial(const GltfDocument& document, int index, const tinygltf::Material& material)
        : document_(document), where_("materials[" + std::to_string(index) + "]"), material_(material) {}

    MaterialDescription run(GltfNotices& notices) const {
        if (material_.extensions.contains("KHR_materials_unlit"))
            document_.fail(where_, "KHR_materials_unlit is not supported; surfaces reflect light",
                           ErrorCode::unsupported);
        say_what_is_left(notices);
        const tinygltf::PbrMetallicRoughness& pbr = material_.pbrMetallicRoughness;
        const double metallic = in_unit(pbr.metallicFactor, "metallicFactor");
        const double roughness = in_unit(pbr.roughnessFactor, "roughnessFactor");
        if (metallic > 0 && metallic < 1)
            notices.add("a metallicFactor between 0 and 1 is taken as 0 below 0.5, else as 1");
        MaterialDescription out;
        out.id = material_.name;
        out.twosided = material_.doubleSided;
        out.distribution = MaterialDescription::Distribution::ggx;
        out.alpha = std::max(roughness * roughness, 0.001);
        if (metallic < 0.5) {
            out.kind = MaterialDescription::Kind::pplastic;
            out.diffuse_reflectance = base_color();
            out.int_ior = index_of_refraction();
            out.ext_ior = 1;
        } else {
            out.kind = MaterialDescription::Kind::roughconductor;
            out.eta = 1.0;
            out.k = absorption(base_color());
        }
        return out;
    }

private:
    [[nodiscard]] double in_unit(double value, const char* name) const {
        if (!(value >= 0 && value <= 1))
            document_.fail(where_, std::string(name) + " is " + std::to_string(value) + "; expected 0 to 1");
        return value;
    }

    [[nodiscard]] glm::dvec3 base_color() const {
        const std::vector<double>& factor = material_.pbrMetallicRoughness.baseColorFactor;
        glm::dvec3 color(1);
        if (factor.size() >= 3)
            for (glm::length_t c = 0; c < 3; ++c)
                color[c] = in_unit(factor[static_cast<std::size_t>(c)], "baseColorFactor");
        return color;
    }

    /// The index 1 - ik of a metal that reflects `reflectance` at normal incidence, k^2 / (4 + k^2). Real
    /// parts from (1 - sqrt r) / (1 + sqrt r) to (1 + sqrt r) / (1 - sqrt r) are possible for a reflectance r
    /// (Gulbrandsen, "Artist Friendly Metallic Fresnel", JCGT 3(4), 2014, which lets its user choose); 1
    /// always is, and is near aluminium's.
    static glm::dvec3 absorption(const glm::dvec3& reflectance) {
        constexpr double most = 100;
        glm::dvec3 k;
        for (glm::length_t c = 0; c < 3; ++c)
            k[c] = std::min(2 * std::sqrt(reflectance[c] / (1 - std::min(reflectance[c], 0.9999))), most);
        return k;
    }

    [[nodiscard]] double index_of_refraction() const {
        const auto extension = material_.extensions.find("KHR_materials_ior");
        if (extension == material_.extensions.end() || !extension->second.Has("ior")) return 1.5;
        const tinygltf::Value& value = extension->second.Get("ior");
        const double ior = value.IsNumber() ? value.GetNumberAsDouble() : -1;
        // 0 stands for an infinite index, a mirror at every angle.
        if (ior == 0) return 1e3;
        if (!(ior >= 1 && ior <= 1e3))
            document_.fail(where_, "KHR_materials_ior: ior is not 0 or a number from 1 to 1000");
        return ior;
    }

    void say_what_is_left(GltfNotices& notices) const {
        const tinygltf::PbrMetallicRoughness& pbr = material_.pbrMetallicRoughness;
        const std::array<int, 5> textures = {pbr.baseColorTexture.index, pbr.metallicRoughnessTexture.index,
                                             material_.normalTexture.index, material_.occlusionTexture.index,
                                             material_.emissiveTexture.index};
        if (std::ranges::any_of(textures, [](int index) { return index >= 0; }))
            notices.add("textures are not followed; the factors of materials count alone");
        if (material_.emissiveTexture.index >= 0 ||
            std::ranges::any_of(material_.emissiveFactor, [](double factor) { return factor != 0; }))
            notices.add("materials that emit light are not followed; they reflect it");
        if (material_.alphaMode != "OPAQUE")
            notices.add("alphaMode " + material_.alphaMode.substr(0, 20) +
                        " is not followed; surfaces are opaque");
        for (const auto& [name, value] : material_.extensions)
            if (std::ranges::find(kFollowed, name) == kFollowed.end())
                notices.add(name.substr(0, 80) + " is not followed");
    }

    const GltfDocument& document_;
    std::string where_;
    const tinygltf::Material& material_;
};

}  // namespace

MaterialDescription read_gltf_material(const GltfDocument& document, int index, GltfNotices& notices) {
    if (index == -1) return GltfMaterial(document, index, tinygltf::Material()).run(notices);
    return GltfMaterial(document, index,
                        document.at(document.model().materials, "materials", index, "a primitive"))
        .run(notices);
}

}  // namespace nicol::scene
