// SPDX-License-Identifier: MIT
// <bsdf>.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>

#include "files/suffix.hpp"
#include "scene/plugin.hpp"
#include "scene/polarizing_plate.hpp"
#include "scene/readers.hpp"
#include "scene/values.hpp"

namespace nicol::scene {
namespace {

constexpr int kMostParts = 64;

struct NamedIor {
    std::string_view name;
    double ior;
};

// The names that Mitsuba 3 has and their values at the sodium line.
constexpr std::array<NamedIor, 23> kNamedIors = {
    {{"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
     {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.3330},
     {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
     {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
     {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
     {"pyrex", 1.470},     {"acrylic glass", 1.49},     {"polypropylene", 1.49},
     {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
     {"pet", 1.5750},      {"diamond", 2.419}}};

double refractive_index(Plugin& plugin, const std::string& name, double otherwise) {
    if (!plugin.has_tag(name, "string")) return plugin.number(name, otherwise, 0.0, kNoLimit, true);
    const std::string text = lower_case(plugin.string(name, ""));
    const auto found = std::ranges::find(kNamedIors, std::string_view(text), &NamedIor::name);
    if (found != kNamedIors.end()) return found->ior;
    std::string list;
    for (const NamedIor& entry : kNamedIors) list.append(list.empty() ? "" : ", ").append(entry.name);
    plugin.fail(name, "is " + in_quotes(text) + "; expected a number or one of " + list);
}

/// A number, or a texture.
struct Roughness {
    double alpha;
    TextureSpecificationPtr texture;

    bool operator==(const Roughness& o) const {
        return texture && o.texture ? *texture == *o.texture : !texture && !o.texture && alpha == o.alpha;
    }
};

/// The geometric mean, which keeps the height of a highlight. None unless both are numbers, or textures
/// that differ in nothing but two colours.
std::optional<Roughness> mean(const Roughness& u, const Roughness& v) {
    if (!u.texture && !v.texture) return Roughness{std::sqrt(u.alpha * v.alpha), nullptr};
    if (!u.texture || !v.texture) return std::nullopt;
    TextureSpecification texture = *u.texture;
    texture.color0 = v.texture->color0;
    texture.color1 = v.texture->color1;
    if (texture != *v.texture) return std::nullopt;
    const auto multiply = [](ColorDescription& color, const ColorDescription& other) {
        color.rgb = glm::sqrt(color.rgb * other.rgb);
        return color.spectrum.empty() && other.spectrum.empty();
    };
    if (!multiply(texture.color0, u.texture->color0) || !multiply(texture.color1, u.texture->color1))
        return std::nullopt;
    return Roughness{u.alpha, std::make_shared<const TextureSpecification>(std::move(texture))};
}

Roughness roughness(const XmlDocument& document, Plugin& plugin, const char* name, double otherwise) {
    // What the tables of a material resolve.
    constexpr double least = 0.001, most = 1.0;
    if (const pugi::xml_node texture = plugin.texture(name))
        return {otherwise, read_texture(document, texture)};
    return {plugin.number(name, otherwise, least, most), nullptr};
}

/// Given once, or for both directions; Mitsuba's parameters.
Roughness roughness(const XmlDocument& document, pugi::xml_node node, Plugin& plugin, Notices& notices,
                    double otherwise) {
    Roughness alpha = roughness(document, plugin, "alpha", otherwise);
    if (!plugin.has("alpha_u") && !plugin.has("alpha_v")) {
        plugin.pass_over({"alpha_u", "alpha_v"});
        return alpha;
    }
    if (plugin.has("alpha")) plugin.fail("alpha", "is given beside alpha_u or alpha_v");
    if (!plugin.has("alpha_u") || !plugin.has("alpha_v"))
        plugin.fail(plugin.has("alpha_u") ? "alpha_u" : "alpha_v",
                    "is given alone; expected alpha, or both alpha_u and alpha_v");
    Roughness u = roughness(document, plugin, "alpha_u", otherwise);
    const Roughness v = roughness(document, plugin, "alpha_v", otherwise);
    if (u == v) return u;
    const std::optional<Roughness> both = mean(u, v);
    if (!both)
        plugin.fail("alpha_v",
                    "differs from alpha_u by its texture; expected two numbers or two checkerboards alike: "
                    "materials are isotropic, and take the mean of both",
                    ErrorCode::unsupported);
    notices.add(node, "alpha_u and alpha_v differ: materials are isotropic, and take sqrt(alpha_u alpha_v)");
    return *both;
}

void read_facets(const XmlDocument& document, pugi::xml_node node, Plugin& plugin, Notices& notices,
                 MaterialDescription& material) {
    material.distribution =
        static_cast<MaterialDescription::Distribution>(plugin.choice("distribution", 0, {"beckmann", "ggx"}));
    const Roughness alpha = roughness(document, node, plugin, notices, material.alpha);
    material.alpha = alpha.alpha;
    material.alpha_texture = alpha.texture;
    plugin.pass_over({"sample_visible"});
}

void read_pplastic(const XmlDocument& document, pugi::xml_node node, Plugin& plugin, Notices& notices,
                   MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::pplastic;
    material.diffuse_reflectance = read_color(document, plugin, "diffuse_reflectance", 0.5, 1.0);
    material.specular_reflectance = read_color(document, plugin, "specular_reflectance", 1.0, 1.0);
    material.int_ior = refractive_index(plugin, "int_ior", material.int_ior);
    material.ext_ior = refractive_index(plugin, "ext_ior", material.ext_ior);
    if (material.int_ior == material.ext_ior) plugin.fail("int_ior", "equals ext_ior; they must differ");
    read_facets(document, node, plugin, notices, material);
}

struct NamedMetal {
    std::string_view name;
    const char* metal;  ///< empty: a mirror of index -i
};

// Mitsuba's names, and the words.
constexpr std::array<NamedMetal, 11> kNamedMetals = {{{"none", ""},
                                                      {"au", "Au"},
                                                      {"gold", "Au"},
                                                      {"ag", "Ag"},
                                                      {"silver", "Ag"},
                                                      {"cu", "Cu"},
                                                      {"copper", "Cu"},
                                                      {"al", "Al"},
                                                      {"aluminium", "Al"},
                                                      {"aluminum", "Al"},
                                                      {"a-c", "a-C"}}};

void read_conductor(const XmlDocument& document, pugi::xml_node node, Plugin& plugin, Notices& notices,
                    MaterialDescription& material) {
    const bool rough = plugin.type() == "roughconductor";
    material.kind = rough ? MaterialDescription::Kind::roughconductor : MaterialDescription::Kind::conductor;
    const std::string name = lower_case(plugin.string("material", "none"));
    const auto found = std::ranges::find(kNamedMetals, std::string_view(name), &NamedMetal::name);
    if (found == kNamedMetals.end())
        plugin.fail("material", "is " + in_quotes(name) +
                                    "; expected one of Au, Ag, Cu, Al, a-C, none, or eta and k instead");
    material.metal = found->metal;
    material.eta = plugin.color("eta", material.eta, 100.0);
    material.k = plugin.color("k", material.k, 100.0);
    for (const char* part : {"eta", "k"})
        if (!material.metal.empty() && plugin.has(part))
            plugin.fail(part, "is given beside material; expected either");
    if (material.eta.spectrum.empty() && material.k.spectrum.empty())
        for (glm::length_t i = 0; i < 3; ++i)
            if (material.eta.rgb[i] == 0.0 && material.k.rgb[i] == 0.0)
                plugin.fail(plugin.has("k") ? "k" : "eta", "and the other part of the index are both 0");
    material.specular_reflectance = read_color(document, plugin, "specular_reflectance", 1.0, 1.0);
    if (rough) read_facets(document, node, plugin, notices, material);
}

/// Parameters of materials that are a table in a file.
void read_tabulated(const XmlDocument& document, Plugin& plugin, MaterialDescription& material) {
    material.filename = plugin.filename("filename");
    material.scale = read_color(document, plugin, "scale", 1.0, kNoLimit);
    material.symmetrize = plugin.boolean("symmetrize", false);
    if (!material.scale.spectrum.empty())
        plugin.fail("scale", "is a table over the wavelength; expected one value or three",
                    ErrorCode::unsupported);
}

void read_measured(const XmlDocument& document, Plugin& plugin, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::measured_polarized;
    read_tabulated(document, plugin, material);
    const double wavelength = plugin.number("wavelength", -1.0);
    if (wavelength != -1.0) material.wavelength = plugin.number("wavelength", 0.0, 0.0, kNoLimit, true);
    plugin.pass_over({"alpha_sample"});
}

/// Why a plug-in of Mitsuba is not there.
std::string reason(pugi::xml_node node) {
    const std::string type = node.attribute("type").value();
    if (is_plate_material(node))
        return "it belongs into a <shape> of type rectangle or disk, before a lamp, in no group";
    if (type.find("dielectric") != std::string::npos) return "nothing passes through a surface";
    if (type == "plastic" || type == "roughplastic") return "its polarized form is pplastic";
    return "";
}

}  // namespace

MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                                  int& left) {
    // This ends circles, and trees that a few <ref>s make large.
    if (left-- == 0)
        document.fail(node, "a bsdf made of more than " + std::to_string(kMostParts) +
                                ", itself counted; does one refer to itself?");
    Plugin plugin(document, node);
    MaterialDescription material;
    if (auto nested = read_nested_material(document, plugin, notices, left)) {
        material = std::move(*nested);
    } else {
        if (plugin.type() == "pplastic") {
            read_pplastic(document, node, plugin, notices, material);
        } else if (plugin.type() == "diffuse") {
            material.reflectance = read_color(document, plugin, "reflectance", 0.5, 1.0);
        } else if (plugin.type() == "conductor" || plugin.type() == "roughconductor") {
            read_conductor(document, node, plugin, notices, material);
        } else if (plugin.type() == "measured_polarized") {
            read_measured(document, plugin, material);
        } else if (plugin.type() == "psh") {
            material.kind = MaterialDescription::Kind::psh;
            read_tabulated(document, plugin, material);
        } else {
            plugin.fail_type(
                "pplastic, diffuse, conductor, roughconductor, measured_polarized, psh, twosided, "
                "normalmap, bumpmap, mask, blendbsdf",
                reason(node));
        }
        plugin.finish();
        static_cast<void>(plugin.objects({}));
    }
    material.id = plugin.id();
    return material;
}

MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node, Notices& notices) {
    int left = kMostParts;
    return read_material(document, node, notices, left);
}

}  // namespace nicol::scene
