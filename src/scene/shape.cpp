// SPDX-License-Identifier: MIT
// <shape>.
#include <algorithm>
#include <array>
#include <cctype>

#include "scene/plugin.hpp"
#include "scene/readers.hpp"

namespace nicol::scene {
namespace {

using Kind = ShapeDescription::Kind;

constexpr std::array<std::string_view, 7> kind_names = {"obj",    "ply",       "off", "stl",
                                                        "sphere", "rectangle", "cube"};

void read_mesh(Plugin& plugin, ShapeDescription& shape) {
    shape.filename = plugin.filename("filename");
    std::string suffix = shape.filename.extension().string();
    std::ranges::transform(suffix, suffix.begin(),
                           [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    if (suffix != "." + plugin.type())
        plugin.fail("filename", "is " + in_quotes(shape.filename.filename().string()) +
                                    "; expected a name in ." + plugin.type() +
                                    " as the type of the shape says");
    shape.face_normals = plugin.boolean("face_normals", false);
    plugin.pass_over({"flip_tex_coords"});
}

}  // namespace

ShapeDescription read_shape(const XmlDocument& document, pugi::xml_node node, pugi::xml_node& bsdf) {
    Plugin plugin(document, node);
    const auto kind = std::ranges::find(kind_names, std::string_view(plugin.type()));
    if (kind == kind_names.end()) plugin.fail_type("obj, ply, off, stl, sphere, rectangle, cube");
    ShapeDescription shape;
    shape.kind = static_cast<Kind>(kind - kind_names.begin());
    shape.id = plugin.id();
    if (shape.kind <= Kind::stl) {
        read_mesh(plugin, shape);
    } else if (shape.kind == Kind::sphere) {
        shape.center = plugin.vector("center", shape.center);
        shape.radius = plugin.number("radius", shape.radius, 0.0, std::numeric_limits<double>::max(), true);
    }
    shape.flip_normals = plugin.boolean("flip_normals", false);
    shape.to_world = plugin.transform("to_world");
    plugin.finish();
    for (const pugi::xml_node object : plugin.objects({"bsdf", "ref"})) {
        if (bsdf) document.fail(object, "a second bsdf in one shape; expected one");
        bsdf = object;
    }
    return shape;
}

}  // namespace nicol::scene
