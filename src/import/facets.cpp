// SPDX-License-Identifier: MIT
// Parameters that <bsdf>s of facets and of boundaries share.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/exponential.hpp>

#include "files/suffix.hpp"
#include "import/material_readers.hpp"
#include "import/text.hpp"
#include "import/values.hpp"

namespace nicol::scene {
namespace {

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

bool same(const TexturedNumber& a, const TexturedNumber& b) {
    return a.texture && b.texture ? *a.texture == *b.texture : !a.texture && !b.texture && a.value == b.value;
}

/// The geometric mean, which keeps the height of a highlight. None unless both are numbers, or textures
/// that differ in nothing but two colours.
std::optional<TexturedNumber> mean(const TexturedNumber& u, const TexturedNumber& v) {
    if (!u.texture && !v.texture) return TexturedNumber(std::sqrt(u.value * v.value));
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
    TexturedNumber both(u.value);
    both.texture = std::make_shared<const TextureSpecification>(std::move(texture));
    return both;
}

TexturedNumber roughness(const MaterialSource& source, const char* name) {
    constexpr double otherwise = 0.1;
    // Range that the tables of a material resolve.
    constexpr double least = 0.001, most = 1.0;
    return read_number(source, name, otherwise, least, most);
}

struct DirectionalRoughness {
    TexturedNumber u, v;
};

/// Given once, or for both directions; Mitsuba's parameters.
DirectionalRoughness roughness(const MaterialSource& source) {
    Plugin& plugin = source.plugin;
    const TexturedNumber alpha = roughness(source, "alpha");
    if (!plugin.has("alpha_u") && !plugin.has("alpha_v")) {
        plugin.pass_over({"alpha_u", "alpha_v"});
        return {alpha, alpha};
    }
    if (plugin.has("alpha")) plugin.fail("alpha", "is given beside alpha_u or alpha_v");
    if (!plugin.has("alpha_u") || !plugin.has("alpha_v"))
        plugin.fail(plugin.has("alpha_u") ? "alpha_u" : "alpha_v",
                    "is given alone; expected alpha, or both alpha_u and alpha_v");
    const TexturedNumber u = roughness(source, "alpha_u");
    return {u, roughness(source, "alpha_v")};
}

Distribution read_distribution(Plugin& plugin) {
    const std::size_t choice = plugin.choice("distribution", 0, {"beckmann", "ggx"});
    plugin.pass_over({"sample_visible"});
    return choice == 0 ? Distribution::beckmann : Distribution::ggx;
}

/// A number, or the name of a medium.
double refractive_index(Plugin& plugin, const std::string& name, double otherwise) {
    if (!plugin.has_tag(name, "string")) return plugin.number(name, otherwise, 0.0, kNoLimit, true);
    const std::string text = lower_case(plugin.string(name, ""));
    const auto found = std::ranges::find(kNamedIors, std::string_view(text), &NamedIor::name);
    if (found != kNamedIors.end()) return found->ior;
    plugin.fail(name, "is " + in_quotes(text) + "; expected a number or one of " +
                          joined(kNamedIors, &NamedIor::name));
}

}  // namespace

TexturedNumber read_number(const MaterialSource& source, const char* name, double otherwise, double least,
                           double most) {
    TexturedNumber number(otherwise);
    if (const pugi::xml_node texture = source.plugin.texture(name))
        number.texture = read_texture(source.document, texture);
    else
        number.value = source.plugin.number(name, otherwise, least, most);
    return number;
}

void read_indices(Plugin& plugin, double& int_ior, double& ext_ior) {
    int_ior = refractive_index(plugin, "int_ior", int_ior);
    ext_ior = refractive_index(plugin, "ext_ior", ext_ior);
    if (int_ior == ext_ior && !plugin.has("film_thickness"))
        plugin.fail("int_ior", "equals ext_ior; they must differ");
}

FilmDescription read_film(const MaterialSource& source) {
    Plugin& plugin = source.plugin;
    const TexturedNumber thickness = read_number(source, "film_thickness", 0, 0, kThickestFilm);
    const double eta = plugin.number("film_eta", 1.5, 0.1, 100);
    FilmDescription out(FilmParameters{.thickness = thickness.value,
                                       .eta = {{eta, -plugin.number("film_k", 0, 0, 100)}},
                                       .wavelengths = {}});
    if (thickness.texture == nullptr) return out;
    if (thickness.texture->times_colors_of)
        plugin.fail("film_thickness", "has colours of a mesh; expected an image or a checkerboard",
                    ErrorCode::unsupported);
    if (!plugin.has("film_thickness_most"))
        plugin.fail("film_thickness_most",
                    "is missing; expected the thickness where the texture is 1, in nm");
    out.thickness = thickness.texture;
    out.least = plugin.number("film_thickness_least", 0, 0, kThickestFilm);
    out.film.thickness = plugin.number("film_thickness_most", 0, 0, kThickestFilm, true);
    return out;
}

FacetDescription read_facets(const MaterialSource& source) {
    const Distribution distribution = read_distribution(source.plugin);
    const auto [u, v] = roughness(source);
    if (same(u, v)) return {distribution, u};
    const std::optional<TexturedNumber> both = mean(u, v);
    if (!both)
        source.plugin.fail("alpha_v",
                           "differs from alpha_u by its texture; expected two numbers or two checkerboards "
                           "alike: this material is isotropic, and takes the mean of both",
                           ErrorCode::unsupported);
    source.notices.add(
        source.node, "alpha_u and alpha_v differ: " + source.plugin.type() + " takes sqrt(alpha_u alpha_v)");
    return {distribution, *both};
}

FacetDescription read_anisotropic_facets(const MaterialSource& source) {
    const Distribution distribution = read_distribution(source.plugin);
    const auto [u, v] = roughness(source);
    if (same(u, v)) return {distribution, u};
    return {distribution, u, v};
}

}  // namespace nicol::scene
