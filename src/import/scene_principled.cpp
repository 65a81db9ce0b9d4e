// SPDX-License-Identifier: MIT
#include "import/scene_materials.hpp"
#include "material/principled.hpp"

namespace nicol::scene {

MaterialPtr make_principled(const PrincipledDescription& d, const SceneChannels& channels,
                            SceneTextures& textures) {
    PrincipledParameters parameters{.eta = d.eta};
    if (d.base_color.texture)
        parameters.base_color = textures.color(*d.base_color.texture);
    else
        parameters.base_color = reflectance(d.base_color, channels);
    const auto number = [&](const TexturedNumber& of) {
        return NumberParameter(of.value, of.texture ? textures.number(*of.texture) : nullptr);
    };
    parameters.roughness = number(d.roughness);
    parameters.anisotropic = number(d.anisotropic);
    parameters.metallic = number(d.metallic);
    parameters.spec_trans = number(d.spec_trans);
    parameters.spec_tint = number(d.spec_tint);
    parameters.sheen = number(d.sheen);
    parameters.sheen_tint = number(d.sheen_tint);
    parameters.flatness = number(d.flatness);
    parameters.clearcoat = number(d.clearcoat);
    parameters.clearcoat_gloss = number(d.clearcoat_gloss);
    return principled(parameters);
}

}  // namespace nicol::scene
