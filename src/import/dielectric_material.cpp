// SPDX-License-Identifier: MIT
// <bsdf>s that light passes.
#include <string>

#include "import/material_readers.hpp"
#include "import/values.hpp"

namespace nicol::scene {
namespace {

/// Whether the scene's integrator, which may follow the bsdf, does. One that is not given does.
bool reflects_often(const XmlDocument& document) {
    Notices heard_elsewhere(document);
    for (const pugi::xml_node node : document.elements(document.root()))
        if (std::string_view(node.name()) == "integrator")
            return read_integrator(document, node, heard_elsewhere).reflects_often;
    return IntegratorDescription().reflects_often;
}

}  // namespace

void read_dielectric(const MaterialSource& source, MaterialDescription& material) {
    Plugin& plugin = source.plugin;
    if (reflects_often(source.document))
        plugin.fail(
            "",
            "lets light through, which is not followed: light is reflected once. With an integrator of "
            "max_depth 2, or \"direct\", it is read as what its boundary reflects",
            ErrorCode::unsupported);
    const bool rough = plugin.type() == "roughdielectric";
    // A metal that absorbs nothing.
    material.kind = rough ? MaterialDescription::Kind::roughconductor : MaterialDescription::Kind::conductor;
    material.int_ior = 1.5046;  // Mitsuba's: glass
    read_indices(plugin, material);
    material.eta = material.int_ior / material.ext_ior;
    material.k = 0.0;
    material.specular_reflectance = read_color(source.document, plugin, "specular_reflectance", 1.0, 1.0);
    static_cast<void>(read_color(source.document, plugin, "specular_transmittance", 1.0, 1.0));
    if (rough) read_facets(source, material);
    source.notices.add_once(source.node,
                            "of dielectric and roughdielectric what passes through them is left out, and "
                            "what is inside");
}

void read_null(MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::mask;
    TextureSpecification nothing;
    nothing.color0 = 0.0;
    material.texture = std::make_shared<const TextureSpecification>(std::move(nothing));
    material.parts.emplace_back();
}

}  // namespace nicol::scene
