// SPDX-License-Identifier: MIT
// <texture>.
#include <glm/mat3x3.hpp>

#include "import/plugin.hpp"
#include "import/readers.hpp"

namespace nicol::scene {
namespace {

/// Returns the effect of a transform on (u, v), which are its x and y.
glm::dmat3 uv_transform(Plugin& plugin) {
    const glm::dmat4 m = plugin.transform("to_uv");
    return {m[0][0], m[0][1], 0, m[1][0], m[1][1], 0, m[3][0], m[3][1], 1};
}

void read_bitmap(Plugin& plugin, TextureSpecification& texture) {
    texture.kind = TextureSpecification::Kind::image;
    texture.filename = plugin.filename("filename");
    texture.raw = plugin.boolean("raw", false);
    using Filter = TextureSampling::Filter;
    using Wrap = TextureSampling::Wrap;
    // Mitsuba's rays are many a pixel, a shaded pixel is one: it takes the mean of what it covers.
    texture.sampling.filter =
        plugin.choice("filter_type", 0, {"bilinear", "nearest"}) == 0 ? Filter::mipmap : Filter::nearest;
    constexpr Wrap wraps[] = {Wrap::repeat, Wrap::mirror, Wrap::clamp};
    texture.sampling.wrap = wraps[plugin.choice("wrap_mode", 0, {"repeat", "mirror", "clamp"})];
    texture.sampling.to_uv = uv_transform(plugin);
    // Steer how Mitsuba stores the values.
    plugin.pass_over({"format", "accel"});
}

void read_checkerboard(Plugin& plugin, TextureSpecification& texture) {
    texture.kind = TextureSpecification::Kind::checkerboard;
    texture.color0 = plugin.color("color0", texture.color0);
    texture.color1 = plugin.color("color1", texture.color1);
    texture.sampling.to_uv = uv_transform(plugin);
}

void read_mesh_attribute(Plugin& plugin, TextureSpecification& texture) {
    const std::string name = plugin.string("name", "");
    const bool of_faces = name.starts_with(kFacePrefix);
    const std::string_view prefix = of_faces ? kFacePrefix : kVertexPrefix;
    if (!name.starts_with(prefix) || name.size() == prefix.size())
        plugin.fail("name", "is " + in_quotes(name) +
                                "; expected vertex_ or face_ and the name of an attribute, as vertex_color");
    texture.color0 = plugin.number("scale", 1.0);
    texture.times_colors_of = of_faces ? ColorsOf::faces : ColorsOf::vertices;
    texture.attribute = name.substr(prefix.size());
}

void read_constant(Plugin& plugin, TextureSpecification& texture) {
    if (!plugin.has("value")) plugin.fail("value", "is missing; expected <float>, <rgb> or <vector>");
    texture.color0 =
        plugin.has_tag("value", "vector") ? plugin.vector("value", {}) : plugin.color("value", 0.0);
}

}  // namespace

TextureSpecificationPtr read_texture(const XmlDocument& document, pugi::xml_node node) {
    Plugin plugin(document, node);
    TextureSpecification texture;
    if (plugin.type() == "bitmap")
        read_bitmap(plugin, texture);
    else if (plugin.type() == "checkerboard")
        read_checkerboard(plugin, texture);
    else if (plugin.type() == "mesh_attribute")
        read_mesh_attribute(plugin, texture);
    else if (plugin.type() == "rawconstant")
        read_constant(plugin, texture);
    else
        plugin.fail_type("bitmap, checkerboard, mesh_attribute, rawconstant");
    plugin.finish();
    static_cast<void>(plugin.objects({}));
    return std::make_shared<const TextureSpecification>(std::move(texture));
}

TexturedColor read_color(const XmlDocument& document, Plugin& plugin, const char* name, double otherwise,
                         double most) {
    if (const pugi::xml_node texture = plugin.texture(name)) return read_texture(document, texture);
    return plugin.color(name, otherwise, most);
}

}  // namespace nicol::scene
