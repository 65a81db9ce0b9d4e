// SPDX-License-Identifier: MIT
// <bsdf>s that hold others.
#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {
namespace {

/// A number of 0 to 1, or a texture.
TextureSpecificationPtr fraction(const XmlDocument& document, Plugin& plugin, const char* name,
                                 double otherwise) {
    if (const pugi::xml_node texture = plugin.texture(name)) return read_texture(document, texture);
    TextureSpecification constant;
    constant.color0 = plugin.number(name, otherwise, 0.0, 1.0);
    return std::make_shared<const TextureSpecification>(std::move(constant));
}

MaterialDescription twosided(const XmlDocument& document, const Plugin& plugin, Notices& notices, int& left) {
    const std::vector<NestedObject> sides = plugin.objects({"bsdf"});
    if (sides.empty()) plugin.fail("", "has no bsdf inside; expected one");
    for (const NestedObject& side : sides) {
        if (std::string_view(side.node.attribute("type").value()) == "twosided")
            document.fail(side.place, "a bsdf \"twosided\" inside another");
        if (side.node != sides.front().node)
            document.fail(side.place, "a second bsdf in a \"twosided\"; both sides must be the same",
                          ErrorCode::unsupported);
    }
    MaterialDescription material = read_material(document, sides.front().node, notices, left);
    material.twosided = true;
    return material;
}

void read_parts(const XmlDocument& document, const Plugin& plugin, std::size_t count, Notices& notices,
                int& left, MaterialDescription& material) {
    const std::vector<NestedObject> parts = plugin.objects({"bsdf"});
    if (parts.size() != count)
        plugin.fail(
            "", "has " + std::to_string(parts.size()) + " bsdfs inside; expected " + std::to_string(count));
    for (const NestedObject& part : parts)
        material.parts.push_back(read_material(document, part.node, notices, left));
}

}  // namespace

std::optional<MaterialDescription> read_nested_material(const XmlDocument& document, Plugin& plugin,
                                                        Notices& notices, int& left) {
    MaterialDescription material;
    if (plugin.type() == "twosided") {
        plugin.finish();
        return twosided(document, plugin, notices, left);
    }
    if (plugin.type() == "normalmap") {
        material.kind = MaterialDescription::Kind::normalmap;
        material.texture = read_texture(document, plugin.only_texture());
        // Of light and views below the horizon of the perturbed normal.
        plugin.pass_over({"use_shadowing_function", "flip_invalid_normals"});
    } else if (plugin.type() == "bumpmap") {
        material.kind = MaterialDescription::Kind::bumpmap;
        material.texture = read_texture(document, plugin.only_texture());
        material.bump_scale = plugin.number("scale", material.bump_scale);
    } else if (plugin.type() == "mask") {
        material.kind = MaterialDescription::Kind::mask;
        material.texture = fraction(document, plugin, "opacity", 0.5);
    } else if (plugin.type() == "blendbsdf") {
        material.kind = MaterialDescription::Kind::blendbsdf;
        if (!plugin.has("weight")) plugin.fail("weight", "is missing; expected a <float> or a <texture>");
        material.texture = fraction(document, plugin, "weight", 0.0);
    } else {
        return std::nullopt;
    }
    plugin.finish();
    read_parts(document, plugin, material.kind == MaterialDescription::Kind::blendbsdf ? 2 : 1, notices, left,
               material);
    return material;
}

}  // namespace nicol::scene
