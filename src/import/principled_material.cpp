// SPDX-License-Identifier: MIT
// <bsdf>s of Disney's material.
#include "import/material_readers.hpp"
#include "material/principled.hpp"

namespace nicol::scene {
namespace {

double index_of(Plugin& plugin) {
    if (plugin.has("eta") && plugin.has("specular"))
        plugin.fail("specular", "is given beside eta; expected either");
    const double specular = plugin.number("specular", 0.5, 0.0, 1.0);
    return plugin.number("eta", index_of_specular(specular), 0.001, 1000.0);
}

}  // namespace

void read_principled(const MaterialSource& source, MaterialDescription& material) {
    material.kind = MaterialDescription::Kind::principled;
    PrincipledDescription& of = material.principled;
    of.base_color = read_color(source.document, source.plugin, "base_color", 0.5, 1.0);
    of.eta = index_of(source.plugin);
    const auto read = [&source](const char* name, TexturedNumber& number) {
        number = read_number(source, name, number.value, 0.0, 1.0);
    };
    read("roughness", of.roughness);
    read("anisotropic", of.anisotropic);
    read("metallic", of.metallic);
    read("spec_trans", of.spec_trans);
    read("spec_tint", of.spec_tint);
    read("sheen", of.sheen);
    read("sheen_tint", of.sheen_tint);
    read("flatness", of.flatness);
    read("clearcoat", of.clearcoat);
    read("clearcoat_gloss", of.clearcoat_gloss);
    source.plugin.pass_over(
        {"diffuse_reflectance_sampling_rate", "main_specular_sampling_rate", "clearcoat_sampling_rate"});

    source.notices.add_once(source.node, "principled depolarizes: what it reflects has s0 alone");
    if (of.spec_trans.texture || of.spec_trans.value > 0)
        source.notices.add_once(
            source.node, "spec_trans: what passes through a surface is left out, what it reflects is not");
}

}  // namespace nicol::scene
