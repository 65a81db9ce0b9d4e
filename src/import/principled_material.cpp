// SPDX-License-Identifier: MIT
// <bsdf>s of Disney's material.
#include "material/principled.hpp"

#include "import/material_readers.hpp"

namespace nicol::scene {
namespace {

double index_of(Plugin& plugin) {
    if (plugin.has("eta") && plugin.has("specular"))
        plugin.fail("specular", "is given beside eta; expected either");
    const double specular = plugin.number("specular", 0.5, 0.0, 1.0);
    return plugin.number("eta", index_of_specular(specular), 0.001, 1000.0);
}

void say_what_passes(const MaterialSource& source, const TexturedNumber& spec_trans) {
    if (spec_trans.texture)
        source.notices.add_once(source.node, "spec_trans is a texture: light passes by its mean");
}

}  // namespace

MaterialDescription read_principled(const MaterialSource& source) {
    using P = PrincipledParameters;
    ModelOf<P> model(principled);
    read_color(source, "base_color", model, &P::base_color);
    model.parameters.eta = index_of(source.plugin);
    read_fraction(source, "roughness", model, &P::roughness);
    read_fraction(source, "anisotropic", model, &P::anisotropic);
    read_fraction(source, "metallic", model, &P::metallic);
    const TexturedNumber spec_trans = read_number(source, "spec_trans", 0.0, 0.0, 1.0);
    model.set(&P::spec_trans, spec_trans);
    read_fraction(source, "spec_tint", model, &P::spec_tint);
    read_fraction(source, "sheen", model, &P::sheen);
    read_fraction(source, "sheen_tint", model, &P::sheen_tint);
    read_fraction(source, "flatness", model, &P::flatness);
    read_fraction(source, "clearcoat", model, &P::clearcoat);
    read_fraction(source, "clearcoat_gloss", model, &P::clearcoat_gloss);
    source.plugin.pass_over(
        {"diffuse_reflectance_sampling_rate", "main_specular_sampling_rate", "clearcoat_sampling_rate"});

    source.notices.add_once(source.node, "principled depolarizes: what it reflects has s0 alone");
    model.parameters.transmits = reflects_often(source.document);
    say_what_passes(source, spec_trans);
    return model;
}

MaterialDescription read_principled_thin(const MaterialSource& source) {
    using P = PrincipledThinParameters;
    ModelOf<P> model(principled_thin);
    read_color(source, "base_color", model, &P::base_color);
    model.parameters.eta = source.plugin.number("eta", 1.5, 0.001, 1000.0);
    read_fraction(source, "roughness", model, &P::roughness);
    const TexturedNumber spec_trans = read_number(source, "spec_trans", 0.0, 0.0, 1.0);
    model.set(&P::spec_trans, spec_trans);
    read_fraction(source, "sheen", model, &P::sheen);
    read_fraction(source, "sheen_tint", model, &P::sheen_tint);
    read_fraction(source, "flatness", model, &P::flatness);
    const TexturedNumber diff_trans = read_number(source, "diff_trans", 0.0, 0.0, 2.0);
    model.parameters.diff_trans = diff_trans.texture ? 1.0 : diff_trans.value;
    // Directions of brushing and tints of a sheet's facets.
    source.plugin.pass_over({"anisotropic", "spec_tint", "diff_trans", "diffuse_reflectance_sampling_rate",
                             "spec_reflectance_sampling_rate", "spec_trans_sampling_rate",
                             "diff_trans_sampling_rate"});
    source.notices.add_once(
        source.node,
        "principledthin reflects on its front; anisotropic, spec_tint and the light of diff_trans behind it "
        "are left out");
    say_what_passes(source, spec_trans);
    return model;
}

}  // namespace nicol::scene
