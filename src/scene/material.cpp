// SPDX-License-Identifier: MIT
// <bsdf>.
#include <algorithm>
#include <array>
#include <cctype>

#include "scene/plugin.hpp"
#include "scene/readers.hpp"

namespace nicol::scene {
namespace {

constexpr double no_limit = std::numeric_limits<double>::max();

struct NamedIor {
    std::string_view name;
    double ior;
};

// The names Mitsuba 3 knows and its values, at the sodium line.
constexpr std::array<NamedIor, 23> named_iors = {
    {{"vacuum", 1.0},      {"helium", 1.000036},        {"hydrogen", 1.000132},
     {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.3330},
     {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
     {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
     {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
     {"pyrex", 1.470},     {"acrylic glass", 1.49},     {"polypropylene", 1.49},
     {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
     {"pet", 1.5750},      {"diamond", 2.419}}};

double refractive_index(Plugin& plugin, const std::string& name, double otherwise) {
    if (!plugin.has_tag(name, "string")) return plugin.number(name, otherwise, 0.0, no_limit, true);
    std::string text = plugin.string(name, "");
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const auto found = std::ranges::find(named_iors, std::string_view(text), &NamedIor::name);
    if (found != named_iors.end()) return found->ior;
    std::string list;
    for (const NamedIor& entry : named_iors) list.append(list.empty() ? "" : ", ").append(entry.name);
    plugin.fail(name, "is " + in_quotes(text) + "; expected a number or one of " + list);
}

void read_pplastic(Plugin& plugin, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::pplastic;
    material.diffuse_reflectance = plugin.color("diffuse_reflectance", 0.5, 1.0);
    material.specular_reflectance = plugin.color("specular_reflectance", 1.0, 1.0);
    material.int_ior = refractive_index(plugin, "int_ior", material.int_ior);
    material.ext_ior = refractive_index(plugin, "ext_ior", material.ext_ior);
    if (material.int_ior == material.ext_ior) plugin.fail("int_ior", "equals ext_ior; they must differ");
    material.distribution =
        static_cast<MaterialDescription::Distribution>(plugin.choice("distribution", 0, {"beckmann", "ggx"}));
    material.alpha = plugin.number("alpha", material.alpha, 0.0, no_limit, true);
    plugin.pass_over({"sample_visible"});
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
    } else if (plugin.type() == "psh") {
        material.kind = MaterialDescription::Kind::psh;
        material.filename = plugin.filename("filename");
        material.scale = plugin.color("scale", 1.0);
    } else {
        plugin.fail_type("pplastic, diffuse, psh");
    }
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return material;
}

}  // namespace nicol::scene
