// SPDX-License-Identifier: MIT
// <bsdf>s of a dielectric boundary over a diffuse base.
#include "material/plastic.hpp"

#include "import/coated_model.hpp"
#include "import/material_readers.hpp"
#include "material/coated_plastic.hpp"

namespace nicol::scene {
namespace {

template <class P>
void read_base_and_boundary(const MaterialSource& source, LateParameters<P>& out) {
    read_color(source, "diffuse_reflectance", out, &P::diffuse_reflectance);
    read_color(source, "specular_reflectance", out, &P::specular_reflectance);
    read_indices(source.plugin, out.parameters.int_ior, out.parameters.ext_ior);
}

}  // namespace

MaterialPtr CoatedPlasticModel::make(const MaterialMaker& maker) const {
    const PplasticParameters plastic = with(maker);
    return with_film(maker, film,
                     [&](const FilmParameters& of_point) { return coated_pplastic(plastic, of_point); });
}

MaterialDescription read_pplastic(const MaterialSource& source) {
    ModelOf<PplasticParameters> model(pplastic);
    read_base_and_boundary(source, model);
    set_facets(read_anisotropic_facets(source), model);
    const FilmDescription film = read_film(source);
    if (film.present()) return CoatedPlasticModel(model, film);
    return model;
}

MaterialDescription read_plastic(const MaterialSource& source) {
    ModelOf<PlasticParameters> model(plastic);
    read_base_and_boundary(source, model);
    model.parameters.nonlinear = source.plugin.boolean("nonlinear", false);
    if (source.plugin.type() == "roughplastic") set_facets(read_facets(source), model);
    source.notices.add_once(source.node,
                            "plastic and roughplastic depolarize; pplastic is the model that polarizes");
    return model;
}

}  // namespace nicol::scene
