// SPDX-License-Identifier: MIT
// <shape>.
#include <algorithm>
#include <array>

#include "files/suffix.hpp"
#include "geometry/mesh.hpp"
#include "geometry/mesh_format.hpp"
#include "import/plugin.hpp"
#include "import/readers.hpp"
#include "import/text.hpp"
#include "import/values.hpp"

namespace nicol::scene {
namespace {

using ShapeKind = ShapeDescription::Kind;

struct KindName {
    std::string_view name;
    ShapeKind kind;
};
constexpr std::array kKindNames = {KindName{"sphere", ShapeKind::sphere},
                                   KindName{"rectangle", ShapeKind::rectangle},
                                   KindName{"cube", ShapeKind::cube},
                                   KindName{"disk", ShapeKind::disk},
                                   KindName{"cylinder", ShapeKind::cylinder},
                                   KindName{"linearcurve", ShapeKind::linear_curve},
                                   KindName{"bsplinecurve", ShapeKind::bspline_curve},
                                   KindName{"sdfgrid", ShapeKind::sdf_grid}};

ShapeKind kind_of(const Plugin& plugin) {
    if (mesh_format_named(plugin.type()) != nullptr) return ShapeKind::file;
    // Mitsuba finds Sphere as sphere where file names are not case-sensitive.
    const std::string type = lower_case(plugin.type());
    const auto* const kind = std::ranges::find(kKindNames, std::string_view(type), &KindName::name);
    if (kind != kKindNames.end()) return kind->kind;
    plugin.fail_type(mesh_format_names() + ", " + joined(kKindNames, &KindName::name) +
                     ", shapegroup, instance, merge");
}

void read_mesh(Plugin& plugin, ShapeDescription& shape) {
    shape.filename = plugin.filename("filename");
    if (suffix_of(shape.filename) != "." + plugin.type())
        plugin.fail("filename", "is " + in_quotes(shape.filename.filename().string()) +
                                    "; expected a name in ." + plugin.type() +
                                    " as the type of the shape says");
    const MeshFormat& format = *mesh_format_named(plugin.type());
    if (format.several_meshes)
        shape.index =
            static_cast<std::size_t>(plugin.integer("shape_index", 0, 0, std::numeric_limits<int>::max()));
    shape.face_normals = plugin.boolean("face_normals", false);
    shape.flip_tex_coords = plugin.boolean("flip_tex_coords", format.upward_texcoords);
}

void read_segments(Plugin& plugin, ShapeDescription& shape) {
    shape.segments = plugin.integer("segments", 0, 0, kMaxSphereSegments);
    if (shape.segments % 2 != 0)
        plugin.fail("segments", "is " + std::to_string(shape.segments) + "; expected an even number");
}

void read_sdf_grid(Plugin& plugin, ShapeDescription& shape) {
    shape.filename = plugin.filename("filename");
    const std::string normals = plugin.string("normals", "smooth");
    if (normals != "smooth" && normals != "analytic")
        plugin.fail("normals", "is " + in_quotes(normals) + "; expected smooth or analytic");
    if (normals == "analytic") shape.sdf_normals = SdfNormals::analytic;
}

}  // namespace

ShapeDescription read_shape(const XmlDocument& document, pugi::xml_node node, Notices& notices,
                            pugi::xml_node& bsdf) {
    Plugin plugin(document, node);
    ShapeDescription shape;
    shape.kind = kind_of(plugin);
    shape.id = plugin.id();
    if (shape.kind == ShapeKind::file) {
        read_mesh(plugin, shape);
    } else if (shape.kind == ShapeKind::sphere) {
        shape.center = plugin.vector("center", shape.center);
        shape.radius = plugin.number("radius", shape.radius, 0.0, kNoLimit, true);
        read_segments(plugin, shape);
    } else if (shape.kind == ShapeKind::cylinder) {
        shape.p0 = plugin.vector("p0", shape.p0);
        shape.p1 = plugin.vector("p1", shape.p1);
        if (shape.p0 == shape.p1) plugin.fail("p1", "is p0; expected two points that differ");
        shape.radius = plugin.number("radius", shape.radius, 0.0, kNoLimit, true);
    } else if (shape.kind == ShapeKind::linear_curve || shape.kind == ShapeKind::bspline_curve) {
        shape.filename = plugin.filename("filename");
    } else if (shape.kind == ShapeKind::sdf_grid) {
        read_sdf_grid(plugin, shape);
    }
    for (const std::string& name : plugin.texture_names()) {
        if (!name.starts_with(kVertexPrefix) && !name.starts_with(kFacePrefix)) continue;
        shape.attributes[name] = read_texture(document, plugin.texture(name));
        if (shape.attributes[name]->times_colors_of)
            plugin.fail(name, "is a mesh_attribute; expected another texture in the place of an attribute",
                        ErrorCode::unsupported);
    }
    shape.flip_normals = plugin.boolean("flip_normals", false);
    shape.to_world = plugin.transform("to_world");
    // Steers Mitsuba's sampling for derivatives.
    plugin.pass_over({"silhouette_sampling_weight"});
    plugin.finish();
    for (const NestedObject& object : plugin.single_objects({"bsdf", "emitter"})) {
        if (std::string_view(object.node.name()) == "bsdf")
            bsdf = object.node;
        else
            shape.emission = read_emission(document, object.node, notices);
    }
    return shape;
}

std::vector<pugi::xml_node> read_group(const XmlDocument& document, pugi::xml_node node) {
    const Plugin plugin(document, node);
    plugin.finish();
    std::vector<pugi::xml_node> members;
    for (const NestedObject& object : plugin.objects({"shape"})) {
        const std::string_view type = object.node.attribute("type").value();
        // This ends circles too.
        if (type == "shapegroup" || type == "instance" || type == "merge")
            document.fail(object.place, "a shape " + in_quotes(type) + " inside a " + plugin.type(),
                          ErrorCode::unsupported);
        members.push_back(object.node);
    }
    return members;
}

pugi::xml_node read_instance(const XmlDocument& document, pugi::xml_node node, ShapeDescription& instance) {
    Plugin plugin(document, node);
    instance.id = plugin.id();
    instance.to_world = plugin.transform("to_world");
    plugin.finish();
    const std::vector<NestedObject> objects = plugin.objects({"shape"});
    if (objects.size() != 1)
        plugin.fail(
            "", "refers to " + std::to_string(objects.size()) + " shapes; expected one, of type shapegroup");
    const std::string_view type = objects.front().node.attribute("type").value();
    if (type != "shapegroup")
        document.fail(objects.front().place,
                      "an instance of a shape " + in_quotes(type) + "; expected a shapegroup");
    return objects.front().node;
}

}  // namespace nicol::scene
