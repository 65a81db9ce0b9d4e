// SPDX-License-Identifier: MIT
#include "import/scene_materials.hpp"

#include <algorithm>
#include <complex>
#include <string>
#include <utility>

#include "error.hpp"
#include "material/conductor.hpp"
#include "material/measured.hpp"
#include "material/mixture.hpp"
#include "material/plastic.hpp"
#include "material/psh_matrix_file.hpp"

namespace nicol::scene {
namespace {

/// One scene's materials.
class Maker {
public:
    Maker(const SceneChannels& channels, SceneTextures& textures, SceneFiles& files)
        : channels_(channels), textures_(textures), files_(files) {}

    MaterialPtr make(const MaterialDescription& d) const {
        files_.budget().check();
        MaterialPtr front = d.parts.empty() ? model(d) : of_parts(d);
        return d.twosided ? twosided(std::move(front)) : front;
    }

private:
    [[nodiscard]] MaterialPtr model(const MaterialDescription& d) const {
        switch (d.kind) {
            case MaterialDescription::Kind::diffuse:
                return diffuse(color(d.reflectance));
            case MaterialDescription::Kind::pplastic:
                return pplastic({.diffuse_reflectance = color(d.diffuse_reflectance),
                                 .specular_reflectance = color(d.specular_reflectance),
                                 .int_ior = d.int_ior,
                                 .ext_ior = d.ext_ior,
                                 .alpha = number(d.alpha, d.alpha_texture),
                                 .distribution = distribution(d)});
            case MaterialDescription::Kind::plastic:
                return plastic({.diffuse_reflectance = color(d.diffuse_reflectance),
                                .specular_reflectance = color(d.specular_reflectance),
                                .int_ior = d.int_ior,
                                .ext_ior = d.ext_ior,
                                .alpha = number(d.alpha, d.alpha_texture),
                                .distribution = distribution(d),
                                .nonlinear = d.nonlinear});
            case MaterialDescription::Kind::conductor:
                return conductor(index_of(d), color(d.specular_reflectance));
            case MaterialDescription::Kind::roughconductor:
                return rough_conductor({.eta = index_of(d),
                                        .specular_reflectance = color(d.specular_reflectance),
                                        .alpha = number(d.alpha, d.alpha_texture),
                                        .alpha_v = number(d.alpha_v, d.alpha_v_texture),
                                        .distribution = distribution(d)});
            case MaterialDescription::Kind::principled:
                return make_principled(d.principled, channels_, textures_);
            case MaterialDescription::Kind::psh:
                return times(files_.read(d.filename, [&] { return matrix(d); }), d.scale.texture);
            default:
                return measured(d);
        }
    }

    [[nodiscard]] MaterialPtr of_parts(const MaterialDescription& d) const {
        MaterialPtr first = make(d.parts.front());
        switch (d.kind) {
            case MaterialDescription::Kind::normalmap:
                return normal_mapped(std::move(first), textures_.vector(*d.texture), d.mirrored_y);
            case MaterialDescription::Kind::bumpmap:
                return bump_mapped(std::move(first), textures_.number(*d.texture), d.bump_scale);
            case MaterialDescription::Kind::mask:
                return alpha_mask(std::move(first), textures_.number(*d.texture));
            default:
                return blend(first, make(d.parts.back()), textures_.number(*d.texture));
        }
    }

    [[nodiscard]] MaterialPtr alpha_mask(MaterialPtr material, TexturePtr opacity) const {
        const float value = opacity->mean().x;
        if (opacity->constant() && value > 0 && value < 1)
            files_.notice("a surface with an opacity between 0 and 1 is " +
                          std::string(value < 0.5F ? "not drawn" : "drawn without seeing through it"));
        return masked(std::move(material), std::move(opacity));
    }

    [[nodiscard]] ColorParameter color(const TexturedColor& color) const {
        if (color.texture) return textures_.color(*color.texture);
        return reflectance(color, channels_);
    }
    [[nodiscard]] NumberParameter number(double value, const TextureSpecificationPtr& texture) const {
        return {value, texture ? textures_.number(*texture) : nullptr};
    }

    static Distribution distribution(const MaterialDescription& d) {
        return d.distribution == MaterialDescription::Distribution::ggx ? Distribution::ggx
                                                                        : Distribution::beckmann;
    }

    /// n - ik, one or one a channel.
    [[nodiscard]] std::vector<std::complex<double>> index_of(const MaterialDescription& d) const {
        if (!d.metal.empty()) {
            if (channels_.rgb()) return metal_index(d.metal);
            if (!channels_.wavelengths.empty()) return metal_index(d.metal, channels_.wavelengths);
            throw Error(ErrorCode::unsupported, "a named metal under light of " +
                                                    std::to_string(channels_.count) +
                                                    " channels without wavelengths; give grey eta and k");
        }
        const std::vector<double> eta = refractive_index(d.eta, channels_);
        const std::vector<double> k = refractive_index(d.k, channels_);
        std::vector<std::complex<double>> index;
        for (std::size_t c = 0; c < std::max(eta.size(), k.size()); ++c)
            index.emplace_back(eta[eta.size() == 1 ? 0 : c], -k[k.size() == 1 ? 0 : c]);
        // Of a table that ends within the visible range, both may be 0.
        std::ranges::replace(index, std::complex<double>(0), std::complex<double>(0.001));
        return index;
    }

    [[nodiscard]] MaterialPtr matrix(const MaterialDescription& d) const {
        std::vector<IsotropicMatrix> matrices = read_psh_matrix(d.filename, files_.budget());
        std::vector<double> scale{1.0};
        if (!d.scale.texture) scale = reflectance(d.scale, channels_);
        if (std::ranges::all_of(scale, [&](double s) { return s == scale.front(); })) scale.resize(1);
        if (matrices.size() == 1) matrices.resize(scale.size(), matrices.front());
        return psh_matrix_material(std::move(matrices), scale, d.symmetrize);
    }

    [[nodiscard]] MaterialPtr measured(const MaterialDescription& d) const {
        MeasuredParameters parameters{.wavelengths = channels_.wavelengths, .symmetrize = d.symmetrize};
        if (d.wavelength) parameters.wavelengths = {*d.wavelength};
        MaterialPtr material = files_.read(d.filename, [&] {
            return load_measured(
                d.filename, parameters, [&](const std::string& text) { files_.notice(text); },
                files_.budget());
        });
        if (d.scale.texture || d.scale.rgb == glm::dvec3(1)) return times(material, d.scale.texture);
        TextureSpecification scale;
        scale.color0 = d.scale;
        return scaled(material, textures_.color(scale));
    }

    [[nodiscard]] MaterialPtr times(const MaterialPtr& material, const TextureSpecificationPtr& scale) const {
        return scale ? scaled(material, textures_.color(*scale)) : material;
    }

    const SceneChannels& channels_;
    SceneTextures& textures_;
    SceneFiles& files_;
};

}  // namespace

MaterialPtr make_material(const MaterialDescription& description, const SceneChannels& channels,
                          SceneTextures& textures, SceneFiles& files) {
    return Maker(channels, textures, files).make(description);
}

}  // namespace nicol::scene
