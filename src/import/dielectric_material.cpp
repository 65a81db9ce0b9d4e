// SPDX-License-Identifier: MIT
// <bsdf>s that light passes.
#include <string>

#include "import/conductor_material.hpp"
#include "import/diffuse_material.hpp"
#include "import/material_readers.hpp"
#include "import/nested_material.hpp"
#include "material/dielectric.hpp"

namespace nicol::scene {
namespace {

/// Reads a factor of 0 to 1 into a parameter.
void read_factor(const MaterialSource& source, const char* name, ModelOf<DielectricParameters>& model,
                 ColorParameter DielectricParameters::*parameter) {
    const TexturedColor color = read_color(source.document, source.plugin, name, 1.0, 1.0);
    if (color.texture)
        source.plugin.fail(name, "is a texture; glass that light passes has constant colours",
                           ErrorCode::unsupported);
    model.set(parameter, color);
}

ModelOf<DielectricParameters> read_glass(const MaterialSource& source,
                                         ModelOf<DielectricParameters>::Make make) {
    ModelOf<DielectricParameters> model(make);
    read_indices(source.plugin, model.parameters.int_ior, model.parameters.ext_ior);
    const FilmDescription film = read_film(source);
    if (film.thickness != nullptr)
        source.plugin.fail("film_thickness", "is a texture; glass that light passes has one thickness",
                           ErrorCode::unsupported);
    model.parameters.film = film.film;
    read_factor(source, "specular_reflectance", model, &DielectricParameters::specular_reflectance);
    read_factor(source, "specular_transmittance", model, &DielectricParameters::specular_transmittance);
    source.notices.add_once(
        source.node,
        "glass dims the light of local lights behind it, and focuses none, but by the reference method");
    return model;
}

/// Returns a body of glass that shows only what its boundary reflects.
MetalModel read_reflection(const MaterialSource& source) {
    DielectricParameters glass;
    read_indices(source.plugin, glass.int_ior, glass.ext_ior);
    // A metal that absorbs nothing.
    MetalModel model;
    model.eta = glass.int_ior / glass.ext_ior;
    model.k = 0.0;
    model.film = read_film(source);
    read_color(source, "specular_reflectance", model, &RoughConductorParameters::specular_reflectance);
    static_cast<void>(read_color(source.document, source.plugin, "specular_transmittance", 1.0, 1.0));
    model.parameters.alpha = 0.0;
    source.notices.add_once(source.node,
                            "of dielectric and roughdielectric what passes through them is left out, and "
                            "what is inside");
    return model;
}

}  // namespace

bool reflects_often(const XmlDocument& document) {
    Notices heard_elsewhere(document);
    for (const pugi::xml_node node : document.elements(document.root()))
        if (std::string_view(node.name()) == "integrator")
            return read_integrator(document, node, heard_elsewhere).reflects_often();
    return IntegratorDescription().reflects_often();
}

MaterialDescription read_dielectric(const MaterialSource& source) {
    if (reflects_often(source.document)) return read_glass(source, dielectric);
    return read_reflection(source);
}

MaterialDescription read_rough_dielectric(const MaterialSource& source) {
    if (reflects_often(source.document)) {
        ModelOf<DielectricParameters> glass = read_glass(source, dielectric);
        const FacetDescription facets = read_facets(source);
        set_facets(facets, glass);
        if (facets.alpha.texture)
            source.notices.add_once(source.node,
                                    "alpha is a texture: facets that transmit light have its mean");
        return glass;
    }
    MetalModel model = read_reflection(source);
    set_facets(read_facets(source), model);
    return model;
}

MaterialDescription read_thin_dielectric(const MaterialSource& source) {
    return read_glass(source, thin_dielectric);
}

MaterialDescription read_null(const MaterialSource&) {
    return MaskModel(DiffuseModel(),
                     std::make_shared<const TextureSpecification>(constant_specification(0.0)));
}

}  // namespace nicol::scene
