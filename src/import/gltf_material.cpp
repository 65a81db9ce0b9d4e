// SPDX-License-Identifier: MIT
// Materials.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "import/brushed_material.hpp"
#include "import/conductor_material.hpp"
#include "import/gltf_readers.hpp"
#include "import/late_parameters.hpp"
#include "import/nested_material.hpp"

namespace nicol::scene {
namespace {

using Part = TextureSpecification::Part;

constexpr std::string_view kAnisotropy = "KHR_materials_anisotropy";
/// Those of a material that have an effect here.
constexpr std::array<std::string_view, 3> kFollowed = {"KHR_materials_ior", "KHR_materials_emissive_strength",
                                                       kAnisotropy};

TextureSpecificationPtr shared(TextureSpecification texture) {
    return std::make_shared<const TextureSpecification>(std::move(texture));
}

class MaterialReader {
public:
    MaterialReader(const GltfDocument& document, const GltfSurface& surface,
                   const tinygltf::Material& material, GltfTextures& textures, GltfNotices& notices)
        : document_(document),
          surface_(surface),
          where_("materials[" + std::to_string(surface.material) + "]"),
          material_(material),
          pbr_(material.pbrMetallicRoughness),
          textures_(textures),
          notices_(notices),
          base_(pbr_.baseColorTexture, where_ + ".baseColorTexture"),
          metallic_roughness_(pbr_.metallicRoughnessTexture, where_ + ".metallicRoughnessTexture"),
          normal_(material.normalTexture, where_ + ".normalTexture"),
          anisotropy_texture_(texture_of(kAnisotropy, "anisotropyTexture")),
          anisotropy_(anisotropy_texture_, where_ + ".anisotropyTexture") {}

    GltfMaterial run() {
        if (material_.extensions.contains("KHR_materials_unlit"))
            document_.fail(where_, "KHR_materials_unlit is not supported; surfaces reflect light",
                           ErrorCode::unsupported);
        say_what_is_left();
        const int set = texcoord_set();
        read_strength();
        MaterialDescription out = blended();
        if (strength_) turn(out);
        if (auto normals = texture(normal_)) {
            const double scale = material_.normalTexture.scale;
            if (!(std::abs(scale) <= 1e3))
                document_.fail(normal_.where, "scale is not a number from -1000 to 1000");
            normals->raw = true;
            // Scales x and y, 2 t - 1, of the normal.
            normals->factor = {scale, scale, 1};
            normals->offset = {(1 - scale) / 2, (1 - scale) / 2, 0};
            NormalMapModel mapped(std::move(out), shared(std::move(*normals)));
            mapped.options = {.mirrored_y = true, .reversed_back = true};
            out = std::move(mapped);
        }
        if (auto opacity = coverage()) {
            MaskModel mask(std::move(out), shared(std::move(*opacity)));
            mask.translucent = material_.alphaMode == "BLEND";
            out = std::move(mask);
        }
        out.id = material_.name;
        out.twosided = material_.doubleSided;
        return {std::move(out), set};
    }

private:
    [[nodiscard]] double in_unit(double value, const char* name) const {
        if (!(value >= 0 && value <= 1))
            document_.fail(where_, std::string(name) + " is " + std::to_string(value) + "; expected 0 to 1");
        return value;
    }

    /// Returns the set that all textures take. Leaves the textures out if the primitive lacks that set.
    int texcoord_set() {
        std::optional<int> set;
        for (const GltfTextureUse* use : {&base_, &metallic_roughness_, &normal_, &anisotropy_}) {
            if (use->index < 0) continue;
            const int wanted = textures_.texcoord_set(*use);
            if (!set) set = wanted;
            if (*set != wanted)
                notices_.add("a material whose textures take several sets of texture coordinates takes " +
                             std::string("those of its base colour for all"));
        }
        has_texcoords_ =
            set && std::ranges::find(surface_.texcoord_sets, *set) != surface_.texcoord_sets.end();
        if (set && !has_texcoords_)
            notices_.add("textures are left out of primitives that lack the texture coordinates they take");
        return has_texcoords_ ? *set : 0;
    }

    [[nodiscard]] std::optional<TextureSpecification> texture(const GltfTextureUse& use) {
        if (!has_texcoords_) return std::nullopt;
        return textures_.read(use);
    }

    [[nodiscard]] glm::dvec4 base_factor() const {
        const std::vector<double>& factor = pbr_.baseColorFactor;
        glm::dvec4 color(1);
        for (std::size_t c = 0; c < std::min(factor.size(), std::size_t{4}); ++c)
            color[static_cast<glm::length_t>(c)] = in_unit(factor[c], "baseColorFactor");
        return color;
    }

    /// The factor, times the texture and the colours of vertices where there are any.
    [[nodiscard]] TexturedColor base_color() {
        const glm::dvec3 factor(base_factor());
        std::optional<TextureSpecification> image = texture(base_);
        if (!image && !surface_.colors) return factor;
        TextureSpecification out = image ? std::move(*image) : constant_specification(factor);
        if (image) out.factor = factor;
        if (surface_.colors) out.times_colors_of = ColorsOf::vertices;
        return shared(std::move(out));
    }

    /// Returns the opacity, for MASK scaled to 0.5 at the cutoff; none if the surface is present everywhere.
    [[nodiscard]] std::optional<TextureSpecification> coverage() {
        if (material_.alphaMode == "OPAQUE") return std::nullopt;
        const bool masks = material_.alphaMode == "MASK";
        if (masks && !(material_.alphaCutoff > 0)) return std::nullopt;
        const double factor = base_factor().w * (masks ? 0.5 / material_.alphaCutoff : 1);
        if (auto image = texture(base_)) {
            image->part = Part::coverage;
            image->factor = glm::dvec3(factor);
            return image;
        }
        if (factor >= (masks ? 0.5 : 1)) return std::nullopt;
        return constant_specification(factor);
    }

    /// Plastic and metal, weighted by how metallic the surface is.
    [[nodiscard]] MaterialDescription blended() {
        const double metallic = in_unit(pbr_.metallicFactor, "metallicFactor");
        std::optional<TextureSpecification> weight;
        if (metallic > 0) weight = texture(metallic_roughness_);
        if (weight) {
            weight->raw = true;
            weight->part = Part::blue;
            weight->factor = glm::dvec3(metallic);
        } else if (metallic == 0) {
            return plastic();
        } else if (metallic == 1) {
            return metal();
        } else {
            weight = constant_specification(metallic);
        }
        return BlendModel{plastic(), metal(), shared(std::move(*weight))};
    }

    [[nodiscard]] MaterialDescription plastic() {
        using P = PplasticParameters;
        ModelOf<P> out(pplastic);
        out.set(&P::diffuse_reflectance, base_color());
        out.set(&P::specular_reflectance, 1.0);
        out.parameters.int_ior = index_of_refraction();
        out.parameters.ext_ior = 1;
        return with_facets(std::move(out));
    }

    /// A mirror times a colour that varies; of one colour, a metal that has it.
    [[nodiscard]] MaterialDescription metal() {
        MetalModel out;
        const TexturedColor color = base_color();
        out.set(&RoughConductorParameters::specular_reflectance, color.texture ? color : 1.0);
        if (!color.texture) {
            out.eta = 1.0;
            out.k = absorption(color.rgb);
        }
        return with_facets(std::move(out));
    }

    template <class Model>
    [[nodiscard]] MaterialDescription with_facets(Model model) {
        FacetDescription facets = this->facets();
        if (strength_ && (facets.alpha.texture || strength_->texture))
            return BrushedModel(
                [model](const FacetDescription& of) {
                    Model out = model;
                    set_facets(of, out);
                    return MaterialDescription(std::move(out));
                },
                std::move(facets.alpha), *strength_);
        if (strength_) {
            facets.alpha_v = facets.alpha;
            facets.alpha.value = widened(facets.alpha.value, strength_->value);
        }
        set_facets(facets, model);
        return model;
    }

    [[nodiscard]] FacetDescription facets() {
        const double roughness = in_unit(pbr_.roughnessFactor, "roughnessFactor");
        FacetDescription out{.distribution = Distribution::ggx,
                             .alpha = std::max(roughness * roughness, 0.001)};
        if (auto image = texture(metallic_roughness_)) {
            image->raw = true;
            image->part = Part::green;
            image->factor = glm::dvec3(roughness);
            image->squared = true;
            out.alpha.texture = shared(std::move(*image));
        }
        return out;
    }

    /// Reads how strong KHR_materials_anisotropy is, if there is any.
    void read_strength() {
        const double strength =
            in_unit(number_of(kAnisotropy, "anisotropyStrength", 0), "anisotropyStrength");
        if (strength == 0) return;
        strength_ = strength;
        if (auto image = texture(anisotropy_)) {
            image->raw = true;
            image->part = Part::blue;
            image->factor = glm::dvec3(strength);
            strength_->texture = shared(std::move(*image));
        }
    }

    /// Rotates the facets as KHR_materials_anisotropy says.
    void turn(MaterialDescription& material) {
        double angle = number_of(kAnisotropy, "anisotropyRotation", 0);
        if (!std::isfinite(angle)) document_.fail(where_, "anisotropyRotation is not a finite number");
        // Half a turn changes nothing.
        angle = std::remainder(angle, std::numbers::pi);
        if (std::abs(angle) < 1e-6) angle = 0;
        std::optional<TextureSpecification> directions = texture(anisotropy_);
        if (!directions && angle == 0) return;
        if (directions) directions->raw = true;
        material =
            RotatedModel(std::move(material), directions ? shared(std::move(*directions)) : nullptr, angle);
    }

    /// A texture that an extension names.
    struct NamedTexture {
        int index = -1;
        int texCoord = 0;
        tinygltf::ExtensionMap extensions;
    };
    [[nodiscard]] NamedTexture texture_of(std::string_view extension, const char* name) const {
        NamedTexture out;
        const tinygltf::Value* const info = value_of(extension, name);
        if (info == nullptr) return out;
        const auto whole = [&](const char* number, int otherwise) {
            if (!info->Has(number)) return otherwise;
            const tinygltf::Value& value = info->Get(number);
            if (!value.IsInt())
                document_.fail(where_, std::string(name) + ": " + number + " is not a whole number");
            return value.GetNumberAsInt();
        };
        out.index = whole("index", -1);
        out.texCoord = whole("texCoord", 0);
        if (info->Has("extensions") && info->Get("extensions").IsObject())
            out.extensions = info->Get("extensions").Get<tinygltf::Value::Object>();
        return out;
    }

    /// Returns a value of an extension, or null.
    [[nodiscard]] const tinygltf::Value* value_of(std::string_view extension, const char* name) const {
        const auto found = material_.extensions.find(std::string(extension));
        if (found == material_.extensions.end() || !found->second.Has(name)) return nullptr;
        return &found->second.Get(name);
    }

    /// Returns a number of an extension, or `otherwise`.
    [[nodiscard]] double number_of(std::string_view extension, const char* name, double otherwise) const {
        const tinygltf::Value* const value = value_of(extension, name);
        if (value == nullptr) return otherwise;
        return value->IsNumber() ? value->GetNumberAsDouble() : std::numeric_limits<double>::quiet_NaN();
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
        const double ior = number_of("KHR_materials_ior", "ior", 1.5);
        // 0 stands for an infinite index, a mirror at every angle.
        if (ior == 0) return 1e3;
        if (!(ior >= 1 && ior <= 1e3))
            document_.fail(where_, "KHR_materials_ior: ior is not 0 or a number from 1 to 1000");
        return ior;
    }

    void say_what_is_left() {
        if (material_.occlusionTexture.index >= 0) notices_.add("occlusion textures are not followed");
        if (material_.emissiveTexture.index >= 0 ||
            std::ranges::any_of(material_.emissiveFactor, [](double factor) { return factor != 0; }))
            notices_.add("materials that emit light are not followed; they reflect it");
        for (const auto& [name, value] : material_.extensions)
            if (std::ranges::find(kFollowed, name) == kFollowed.end())
                notices_.add(name.substr(0, 80) + " is not followed");
    }

    const GltfDocument& document_;
    const GltfSurface& surface_;
    std::string where_;
    const tinygltf::Material& material_;
    const tinygltf::PbrMetallicRoughness& pbr_;
    GltfTextures& textures_;
    GltfNotices& notices_;
    GltfTextureUse base_, metallic_roughness_, normal_;
    NamedTexture anisotropy_texture_;
    GltfTextureUse anisotropy_;
    std::optional<TexturedNumber> strength_;  ///< none: no anisotropy
    bool has_texcoords_ = false;
};

}  // namespace

GltfMaterial read_gltf_material(const GltfDocument& document, const GltfSurface& surface,
                                GltfTextures& textures, GltfNotices& notices) {
    const tinygltf::Material none;
    const tinygltf::Material& material =
        surface.material == -1
            ? none
            : document.at(document.model().materials, "materials", surface.material, "a primitive");
    return MaterialReader(document, surface, material, textures, notices).run();
}

}  // namespace nicol::scene
