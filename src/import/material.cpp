// SPDX-License-Identifier: MIT
// <bsdf>.
#include "import/material_readers.hpp"
#include "import/polarization_element.hpp"
#include "import/values.hpp"

namespace nicol::scene {
namespace {

constexpr int kMostParts = 64;

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
    if (is_element_material(node))
        return "it belongs into a <shape> of type rectangle or disk that emits no light";
    if (type == "thindielectric" || type == "principledthin") return "nothing passes through a surface";
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
        const MaterialSource source{document, node, plugin, notices};
        if (plugin.type() == "pplastic") {
            read_pplastic(source, material);
        } else if (plugin.type() == "plastic" || plugin.type() == "roughplastic") {
            read_plastic(source, material);
        } else if (plugin.type() == "dielectric" || plugin.type() == "roughdielectric") {
            read_dielectric(source, material);
        } else if (plugin.type() == "null") {
            read_null(material);
        } else if (plugin.type() == "diffuse") {
            material.reflectance = read_color(document, plugin, "reflectance", 0.5, 1.0);
        } else if (plugin.type() == "conductor" || plugin.type() == "roughconductor") {
            read_conductor(source, material);
        } else if (plugin.type() == "principled") {
            read_principled(source, material);
        } else if (plugin.type() == "measured_polarized") {
            read_measured(document, plugin, material);
        } else if (plugin.type() == "psh") {
            material.kind = MaterialDescription::Kind::psh;
            read_tabulated(document, plugin, material);
        } else {
            plugin.fail_type(
                "pplastic, plastic, roughplastic, diffuse, conductor, roughconductor, dielectric, "
                "roughdielectric, null, principled, measured_polarized, psh, twosided, normalmap, bumpmap, "
                "mask, blendbsdf",
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
