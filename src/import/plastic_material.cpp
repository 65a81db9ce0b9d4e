// SPDX-License-Identifier: MIT
// <bsdf>s of a dielectric boundary over a diffuse base.
#include "import/material_readers.hpp"

namespace nicol::scene {
namespace {

void read_base_and_boundary(const MaterialSource& source, MaterialDescription& material) {
    Plugin& plugin = source.plugin;
    material.diffuse_reflectance = read_color(source.document, plugin, "diffuse_reflectance", 0.5, 1.0);
    material.specular_reflectance = read_color(source.document, plugin, "specular_reflectance", 1.0, 1.0);
    read_indices(plugin, material);
}

}  // namespace

void read_pplastic(const MaterialSource& source, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::pplastic;
    read_base_and_boundary(source, material);
    read_facets(source, material);
}

void read_plastic(const MaterialSource& source, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::plastic;
    read_base_and_boundary(source, material);
    material.nonlinear = source.plugin.boolean("nonlinear", false);
    if (source.plugin.type() == "roughplastic")
        read_facets(source, material);
    else
        material.alpha = 0.0;
    source.notices.add_once(source.node,
                            "plastic and roughplastic depolarize; pplastic is the model that polarizes");
}

}  // namespace nicol::scene
