// SPDX-License-Identifier: MIT
// <bsdf>s that light passes.
#include <string>

#include "import/conductor_material.hpp"
#include "import/diffuse_material.hpp"
#include "import/material_readers.hpp"
#include "import/nested_material.hpp"

namespace nicol::scene {
namespace {

/// Whether the scene's integrator, which may follow the bsdf, does. One that is not given does.
bool reflects_often(const XmlDocument& document) {
    Notices heard_elsewhere(document);
    for (const pugi::xml_node node : document.elements(document.root()))
        if (std::string_view(node.name()) == "integrator")
            return read_integrator(document, node, heard_elsewhere).reflects_often();
    return IntegratorDescription().reflects_often();
}

}  // namespace

MaterialDescription read_dielectric(const MaterialSource& source) {
    Plugin& plugin = source.plugin;
    if (reflects_often(source.document))
        plugin.fail(
            "",
            "lets light through, which is not followed: light is reflected once. With an integrator of "
            "max_depth 2, or \"direct\", it is read as what its boundary reflects",
            ErrorCode::unsupported);
    double int_ior = 1.5046;  // Mitsuba's: glass
    double ext_ior = 1.000277;
    read_indices(plugin, int_ior, ext_ior);
    // A metal that absorbs nothing.
    MetalModel model;
    model.eta = int_ior / ext_ior;
    model.k = 0.0;
    read_color(source, "specular_reflectance", model, &RoughConductorParameters::specular_reflectance);
    static_cast<void>(read_color(source.document, plugin, "specular_transmittance", 1.0, 1.0));
    model.parameters.alpha = 0.0;
    if (plugin.type() == "roughdielectric") set_facets(read_facets(source), model);
    source.notices.add_once(source.node,
                            "of dielectric and roughdielectric what passes through them is left out, and "
                            "what is inside");
    return model;
}

MaterialDescription read_null(const MaterialSource&) {
    return MaskModel(DiffuseModel(),
                     std::make_shared<const TextureSpecification>(constant_specification(0.0)));
}

}  // namespace nicol::scene
