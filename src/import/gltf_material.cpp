// SPDX-License-Identifier: MIT
// Materials.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>

#include "import/coated_model.hpp"
#include "import/conductor_material.hpp"
#include "import/diffuse_material.hpp"
#include "import/gltf_clearcoat.hpp"
#include "import/gltf_extension.hpp"
#include "import/gltf_iridescence.hpp"
#include "import/gltf_left_out.hpp"
#include "import/gltf_models.hpp"
#include "import/gltf_readers.hpp"
#include "import/gltf_transmission.hpp"
#include "import/late_parameters.hpp"
#include "import/nested_material.hpp"

namespace nicol::scene {
namespace {

using Part = TextureSpecification::Part;

/// The reflectance of kIndex at normal incidence.
constexpr double kPlasticReflectance = 0.04;
/// Reflectance at normal incidence of a metal below a film, beside its colour if a texture gives that.
constexpr double kBelowFilm = 0.8;

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
          anisotropy_(document, material.extensions, kAnisotropy, where_),
          specular_(document, material.extensions, kSpecular, where_),
          is_unlit_(material.extensions.contains(kUnlit)),
          is_specular_(specular_.present() &&
                       (requires_specular() || pbr_ == tinygltf::PbrMetallicRoughness{})),
          base_(is_specular_ ? specular_.texture("diffuseTexture")
                             : texture_use(pbr_.baseColorTexture, where_ + ".baseColorTexture")),
          facets_(is_specular_
                      ? specular_.texture("specularGlossinessTexture")
                      : texture_use(pbr_.metallicRoughnessTexture, where_ + ".metallicRoughnessTexture")),
          normal_(texture_use(material.normalTexture, where_ + ".normalTexture")),
          directions_(anisotropy_.texture("anisotropyTexture")) {
        if (!is_unlit_ && !is_specular_) {
            transmission_ = read_transmission(document, material, where_, notices);
            iridescence_ = read_iridescence(document, material, where_, transmission_.share > 0, notices);
        }
        if (!is_unlit_) coat_ = read_clearcoat(document, material, where_, transmission_.share > 0, notices);
    }

    GltfMaterial run() {
        say_what_is_left(material_, is_specular_, notices_);
        GltfMaterial made{black(), texcoord_set(), {}};
        if (is_unlit_)
            made.emission = emission();
        else
            made.description = reflecting();
        MaterialDescription& out = made.description;
        if (auto opacity = coverage()) {
            MaskModel mask(std::move(out), shared(std::move(*opacity)));
            mask.translucent = material_.alphaMode == "BLEND";
            out = std::move(mask);
        }
        out.id = material_.name;
        out.twosided = material_.doubleSided && transmission_.share == 0;
        if (transmission_.share > 0) out = GlassModel(std::move(out), glass());
        return made;
    }

private:
    static MaterialDescription black() {
        DiffuseModel out;
        out.reflectance = 0.0;
        return out;
    }

    /// Returns the base colour as radiance.
    [[nodiscard]] EmissionDescription emission() {
        EmissionDescription out;
        out.radiance = base_color();
        out.two_sided = material_.doubleSided;
        return out;
    }

    [[nodiscard]] MaterialDescription reflecting() {
        read_strength();
        MaterialDescription out = is_specular_ ? specular() : iridescent();
        if (strength_) turn(out);
        if (coat_.factor > 0)
            out = ClearcoatModel(std::move(out), coat_, texture(coat_.share_texture),
                                 texture(coat_.roughness_texture));
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
        return out;
    }

    [[nodiscard]] bool requires_specular() const {
        const std::vector<std::string>& names = document_.model().extensionsRequired;
        return std::ranges::find(names, kSpecular) != names.end();
    }

    [[nodiscard]] double in_unit(double value, const char* name) const {
        return document_.in_range(value, 0, 1, where_, name);
    }

    /// Returns the set that all textures take. Leaves the textures out if the primitive lacks that set.
    int texcoord_set() {
        std::optional<int> set;
        for (const GltfTextureUse* use :
             {&base_, &facets_, &normal_, &directions_, &iridescence_.texture, &iridescence_.thickness,
              &coat_.share_texture, &coat_.roughness_texture}) {
            if (use->index < 0 || (is_unlit_ && use != &base_)) continue;
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

    /// Returns up to four numbers of 0 to 1; those that are not there are 1.
    [[nodiscard]] glm::dvec4 factors(const std::vector<double>& given, const char* name) const {
        glm::dvec4 out(1);
        for (std::size_t c = 0; c < std::min(given.size(), std::size_t{4}); ++c)
            out[static_cast<glm::length_t>(c)] = in_unit(given[c], name);
        return out;
    }

    [[nodiscard]] glm::dvec4 base_factor() const {
        return is_specular_ ? factors(specular_.numbers("diffuseFactor", 4), "diffuseFactor")
                            : factors(pbr_.baseColorFactor, "baseColorFactor");
    }

    /// Returns `scale` times the factor, the texture and the colours of vertices where there are any.
    [[nodiscard]] TexturedColor base_color(double scale = 1) {
        const glm::dvec3 factor = scale * glm::dvec3(base_factor());
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

    /// Returns blended() with a film on the share of the surface that has one.
    [[nodiscard]] MaterialDescription iridescent() {
        if (iridescence_.factor == 0) return blended();
        std::optional<TextureSpecification> weight = texture(iridescence_.texture);
        if (weight) {
            weight = as_number(std::move(*weight), Part::red, iridescence_.factor);
        } else if (iridescence_.factor < 1) {
            weight = constant_specification(iridescence_.factor);
        }
        MaterialDescription bare = blended();
        film_ = iridescence_.film;
        if (auto image = texture(iridescence_.thickness)) {
            film_.thickness = shared(as_number(std::move(*image), Part::green, 1));
            film_.least = iridescence_.least;
        }
        if (!weight) return blended();
        return BlendModel(std::move(bare), blended(), shared(std::move(*weight)));
    }

    /// Plastic and metal, weighted by how metallic the surface is.
    [[nodiscard]] MaterialDescription blended() {
        const double metallic = in_unit(pbr_.metallicFactor, "metallicFactor");
        std::optional<TextureSpecification> weight;
        if (metallic > 0) weight = texture(facets_);
        if (weight) {
            weight = as_number(std::move(*weight), Part::blue, metallic);
        } else if (metallic == 0) {
            return plastic(1.0, read_index(document_, material_, where_));
        } else if (metallic == 1) {
            return metal(base_color());
        } else {
            weight = constant_specification(metallic);
        }
        return BlendModel{plastic(1.0, read_index(document_, material_, where_)), metal(base_color()),
                          shared(std::move(*weight))};
    }

    /// Plastic and a mirror whose sum reflects the specular colour s at normal incidence, and s + (1 - s) f
    /// where the plastic alone reflects 0.04 + 0.96 f. Each part depends on one texture. A conversion to
    /// metal and base colour would need the texels of both at once.
    [[nodiscard]] MaterialDescription specular() {
        constexpr double range = 1 - kPlasticReflectance;
        const TexturedColor more = specular_color(1 / range, -kPlasticReflectance / range);
        const bool has_mirror = more.texture || more.rgb != glm::dvec3(0);
        if (has_mirror && !more.texture && glm::dvec3(base_factor()) == glm::dvec3(0))
            return metal(specular_color(1, 0));
        // A specular colour below the plastic's weakens what its boundary reflects.
        MaterialDescription coat = plastic(specular_color(1 / kPlasticReflectance, 0), kIndex);
        if (!has_mirror) return coat;
        const TexturedColor rest = specular_color(-1 / range, 1 / range);
        return SpecularModel(std::move(coat),
                             rest.texture ? rest.texture : shared(constant_specification(rest)),
                             mirror(more));
    }

    /// Returns slope s + offset for the specular colour s, clamped to 0 to 1.
    [[nodiscard]] TexturedColor specular_color(double slope, double offset) {
        const glm::dvec3 factor(factors(specular_.numbers("specularFactor", 3), "specularFactor"));
        auto image = texture(facets_);
        if (!image) return glm::clamp(slope * factor + offset, 0.0, 1.0);
        image->factor = slope * factor;
        image->offset = glm::dvec3(offset);
        image->clamped = true;
        return shared(std::move(*image));
    }

    [[nodiscard]] MaterialDescription plastic(const TexturedColor& boundary, double index) {
        using P = PplasticParameters;
        ModelOf<P> out(pplastic);
        out.set(&P::diffuse_reflectance, base_color(1 - transmission_.share));
        out.set(&P::specular_reflectance, boundary);
        out.parameters.int_ior = index;
        out.parameters.ext_ior = 1;
        if (film_.present()) return with_facets(CoatedPlasticModel(out, film_));
        return with_facets(std::move(out));
    }

    /// A mirror times a colour that varies; of one colour, a metal that has it.
    [[nodiscard]] MaterialDescription metal(const TexturedColor& color) {
        if (color.texture && !film_.present()) return mirror(color);
        // A film over a perfect mirror has no colours, so that a metal whose colour varies has an index, too.
        const glm::dvec3 reflected = color.texture ? glm::dvec3(kBelowFilm) : color.rgb;
        MetalModel out;
        out.set(&RoughConductorParameters::specular_reflectance, color.texture ? color : TexturedColor(1.0));
        out.eta = 1.0;
        out.k = extinction_of(reflected);
        out.film = film_;
        return with_facets(std::move(out));
    }

    [[nodiscard]] MaterialDescription mirror(const TexturedColor& color) {
        MetalModel out;
        out.set(&RoughConductorParameters::specular_reflectance, color);
        return with_facets(std::move(out));
    }

    template <class Model>
    [[nodiscard]] MaterialDescription with_facets(Model model) {
        return faceted(std::move(model), facets(), strength_);
    }

    [[nodiscard]] FacetDescription facets() {
        const double factor = is_specular_ ? specular_.number("glossinessFactor", 1, 0, 1)
                                           : in_unit(pbr_.roughnessFactor, "roughnessFactor");
        const double roughness = is_specular_ ? 1 - factor : factor;
        FacetDescription out{.distribution = Distribution::ggx,
                             .alpha = std::max(roughness * roughness, 0.001)};
        if (auto image = texture(facets_)) {
            image->raw = !is_specular_;  // its colours are those of specular_color()
            image->part = is_specular_ ? Part::coverage : Part::green;
            image->factor = glm::dvec3(is_specular_ ? -factor : factor);
            image->offset = glm::dvec3(is_specular_ ? 1 : 0);
            image->squared = true;
            out.alpha.texture = shared(std::move(*image));
        }
        return out;
    }

    /// Returns the boundary that light passes.
    [[nodiscard]] GlassDescription glass() {
        return {.index = read_index(document_, material_, where_),
                .share = transmission_.share,
                .color = base_color(),
                .alpha = facets().alpha,
                .is_body = transmission_.is_body,
                .absorption = transmission_.absorption,
                .film = iridescence_.factor < 1 ? FilmParameters() : iridescence_.film};
    }

    /// Reads how strong KHR_materials_anisotropy is, if there is any.
    void read_strength() {
        const double strength = anisotropy_.number("anisotropyStrength", 0, 0, 1);
        if (strength == 0) return;
        strength_ = strength;
        if (auto image = texture(directions_))
            strength_->texture = shared(as_number(std::move(*image), Part::blue, strength));
    }

    /// Rotates the facets as KHR_materials_anisotropy says.
    void turn(MaterialDescription& material) {
        // Half a turn changes nothing.
        double angle = std::remainder(anisotropy_.number("anisotropyRotation", 0), std::numbers::pi);
        if (std::abs(angle) < 1e-6) angle = 0;
        std::optional<TextureSpecification> directions = texture(directions_);
        if (!directions && angle == 0) return;
        if (directions) directions->raw = true;
        material =
            RotatedModel(std::move(material), directions ? shared(std::move(*directions)) : nullptr, angle);
    }

    const GltfDocument& document_;
    const GltfSurface& surface_;
    std::string where_;
    const tinygltf::Material& material_;
    const tinygltf::PbrMetallicRoughness& pbr_;
    GltfTextures& textures_;
    GltfNotices& notices_;
    GltfExtension anisotropy_, specular_;
    bool is_unlit_;
    bool is_specular_;       ///< by specular and glossiness, not by metal and roughness
    GltfTextureUse base_;    ///< base colour or diffuse colour, with coverage
    GltfTextureUse facets_;  ///< metal and roughness, or specular colour and glossiness
    GltfTextureUse normal_;
    GltfTextureUse directions_;               ///< directions of anisotropy
    std::optional<TexturedNumber> strength_;  ///< none: no anisotropy
    GltfTransmission transmission_;           ///< light that passes the surface
    GltfIridescence iridescence_;
    GltfClearcoat coat_;
    FilmDescription film_;  ///< film on the parts of the material that are read now
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
