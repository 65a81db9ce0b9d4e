// SPDX-License-Identifier: MIT
// <bsdf>.
#include <algorithm>
#include <array>

#include "files/suffix.hpp"
#include "scene/plugin.hpp"
#include "scene/readers.hpp"
#include "scene/values.hpp"

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

double refractive_index(Plugin& plugin, const std::string& name, double otherwise) {
    if (!plugin.has_tag(name, "string")) return plugin.number(name, otherwise, 0.0, kNoLimit, true);
    const std::string text = lower_case(plugin.string(name, ""));
    const auto found = std::ranges::find(kNamedIors, std::string_view(text), &NamedIor::name);
    if (found != kNamedIors.end()) return found->ior;
    std::string list;
    for (const NamedIor& entry : kNamedIors) list.append(list.empty() ? "" : ", ").append(entry.name);
    plugin.fail(name, "is " + in_quotes(text) + "; expected a number or one of " + list);
}

/// The roughness, given once or alike for both directions; Mitsuba's parameters.
double roughness(Plugin& plugin, double otherwise) {
    // What the tables of a material resolve.
    constexpr double least = 0.001, most = 1.0;
    const double alpha = plugin.number("alpha", otherwise, least, most);
    if (!plugin.has("alpha_u") && !plugin.has("alpha_v")) {
        plugin.pass_over({"alpha_u", "alpha_v"});
        return alpha;
    }
    if (plugin.has("alpha")) plugin.fail("alpha", "is given beside alpha_u or alpha_v");
    if (!plugin.has("alpha_u") || !plugin.has("alpha_v"))
        plugin.fail(plugin.has("alpha_u") ? "alpha_u" : "alpha_v",
                    "is given alone; expected alpha, or both alpha_u and alpha_v");
    const double alpha_u = plugin.number("alpha_u", otherwise, least, most);
    if (alpha_u != plugin.number("alpha_v", otherwise, least, most))
        plugin.fail("alpha_v", "differs from alpha_u; only isotropic materials are supported",
                    ErrorCode::unsupported);
    return alpha_u;
}

void read_facets(Plugin& plugin, MaterialDescription& material) {
    material.distribution =
        static_cast<MaterialDescription::Distribution>(plugin.choice("distribution", 0, {"beckmann", "ggx"}));
    material.alpha = roughness(plugin, material.alpha);
    plugin.pass_over({"sample_visible"});
}

void read_pplastic(Plugin& plugin, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::pplastic;
    material.diffuse_reflectance = plugin.color("diffuse_reflectance", 0.5, 1.0);
    material.specular_reflectance = plugin.color("specular_reflectance", 1.0, 1.0);
    material.int_ior = refractive_index(plugin, "int_ior", material.int_ior);
    material.ext_ior = refractive_index(plugin, "ext_ior", material.ext_ior);
    if (material.int_ior == material.ext_ior) plugin.fail("int_ior", "equals ext_ior; they must differ");
    read_facets(plugin, material);
}

struct NamedMetal {
    std::string_view name;
    const char* metal;  ///< empty: a mirror of index -i
};

// Mitsuba's names, and the words.
constexpr std::array<NamedMetal, 10> kNamedMetals = {{{"none", ""},
                                                      {"au", "Au"},
                                                      {"gold", "Au"},
                                                      {"ag", "Ag"},
                                                      {"silver", "Ag"},
                                                      {"cu", "Cu"},
                                                      {"copper", "Cu"},
                                                      {"al", "Al"},
                                                      {"aluminium", "Al"},
                                                      {"aluminum", "Al"}}};

void read_conductor(Plugin& plugin, MaterialDescription& material) {
    const bool rough = plugin.type() == "roughconductor";
    material.kind = rough ? MaterialDescription::Kind::roughconductor : MaterialDescription::Kind::conductor;
    const std::string name = lower_case(plugin.string("material", "none"));
    const auto found = std::ranges::find(kNamedMetals, std::string_view(name), &NamedMetal::name);
    if (found == kNamedMetals.end())
        plugin.fail("material",
                    "is " + in_quotes(name) + "; expected one of Au, Ag, Cu, Al, none, or eta and k instead");
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
    material.specular_reflectance = plugin.color("specular_reflectance", 1.0, 1.0);
    if (rough) read_facets(plugin, material);
}

void read_measured(Plugin& plugin, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::measured_polarized;
    material.filename = plugin.filename("filename");
    const double wavelength = plugin.number("wavelength", -1.0);
    if (wavelength != -1.0) material.wavelength = plugin.number("wavelength", 0.0, 0.0, kNoLimit, true);
    material.symmetrize = plugin.boolean("symmetrize", false);
    plugin.pass_over({"alpha_sample"});
}

MaterialDescription read_twosided(const XmlDocument& document, const Plugin& plugin) {
    const std::vector<NestedObject> sides = plugin.objects({"bsdf"});
    if (sides.empty()) plugin.fail("", "has no bsdf inside; expected one");
    for (const NestedObject& side : sides) {
        // This ends circles too.
        if (std::string_view(side.node.attribute("type").value()) == "twosided")
            document.fail(side.place, "a bsdf \"twosided\" inside another");
        if (side.node != sides.front().node)
            document.fail(side.place, "a second bsdf in a \"twosided\"; both sides must be the same",
                          ErrorCode::unsupported);
    }
    MaterialDescription material = read_material(document, sides.front().node);
    material.twosided = true;
    material.id = plugin.id();
    return material;
}

/// Why a plug-in of Mitsuba is not there.
std::string reason(const std::string& type) {
    if (type == "mask") return "surfaces are opaque";
    if (type == "bumpmap" || type == "normalmap") return "normals come from the mesh alone";
    if (type.find("dielectric") != std::string::npos) return "nothing passes through a surface";
    if (type == "plastic" || type == "roughplastic") return "its polarized form is pplastic";
    return "";
}

}  // namespace

MaterialDescription read_material(const XmlDocument& document, pugi::xml_node node) {
    Plugin plugin(document, node);
    MaterialDescription material;
    material.id = plugin.id();
    if (plugin.type() == "pplastic") {
        read_pplastic(plugin, material);
    } else if (plugin.type() == "diffuse") {
        material.reflectance = plugin.color("reflectance", 0.5, 1.0);
    } else if (plugin.type() == "conductor" || plugin.type() == "roughconductor") {
        read_conductor(plugin, material);
    } else if (plugin.type() == "measured_polarized") {
        read_measured(plugin, material);
    } else if (plugin.type() == "psh") {
        material.kind = MaterialDescription::Kind::psh;
        material.filename = plugin.filename("filename");
        material.scale = plugin.color("scale", 1.0);
        material.symmetrize = plugin.boolean("symmetrize", false);
        if (!material.scale.spectrum.empty())
            plugin.fail("scale", "is a table over the wavelength; expected one value or three",
                        ErrorCode::unsupported);
    } else if (plugin.type() == "twosided") {
        plugin.finish();
        return read_twosided(document, plugin);
    } else {
        plugin.fail_type("pplastic, diffuse, conductor, roughconductor, measured_polarized, psh, twosided",
                         reason(plugin.type()));
    }
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return material;
}

}  // namespace nicol::scene
