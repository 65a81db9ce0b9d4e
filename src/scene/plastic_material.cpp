// SPDX-License-Identifier: MIT
// <bsdf>s of a dielectric boundary over a diffuse base.
#include "scene/material_readers.hpp"

namespace nicol::scene {

void read_pplastic(const MaterialSource& source, MaterialDescription& material) {
    Plugin& plugin = source.plugin;
    material.kind = MaterialDescription::Kind::pplastic;
    material.diffuse_reflectance = read_color(source.document, plugin, "diffuse_reflectance", 0.5, 1.0);
    material.specular_reflectance = read_color(source.document, plugin, "specular_reflectance", 1.0, 1.0);
    material.int_ior = refractive_index(plugin, "int_ior", material.int_ior);
    material.ext_ior = refractive_index(plugin, "ext_ior", material.ext_ior);
    if (material.int_ior == material.ext_ior) plugin.fail("int_ior", "equals ext_ior; they must differ");
    read_facets(source, material);
}

}  // namespace nicol::scene
