// SPDX-License-Identifier: MIT
#include "import/scene_materials.hpp"
#include "material/principled.hpp"

namespace nicol::scene {

MaterialPtr make_principled(const PrincipledDescription& d, const SceneChannels& channels,
                            SceneTextures& textures) {
    PrincipledParameters parameters{.eta = d.eta};
    PrincipledTextures varying;
    if (d.base_color.texture)
        varying.base_color = textures.color(*d.base_color.texture);
    else
        parameters.base_color = reflectance(d.base_color, channels);
    const auto take = [&](const TexturedNumber& number, double& value, TexturePtr& texture) {
        value = number.value;
        if (number.texture) texture = textures.number(*number.texture);
    };
    take(d.roughness, parameters.roughness, varying.roughness);
    take(d.anisotropic, parameters.anisotropic, varying.anisotropic);
    take(d.metallic, parameters.metallic, varying.metallic);
    take(d.spec_trans, parameters.spec_trans, varying.spec_trans);
    take(d.spec_tint, parameters.spec_tint, varying.spec_tint);
    take(d.sheen, parameters.sheen, varying.sheen);
    take(d.sheen_tint, parameters.sheen_tint, varying.sheen_tint);
    take(d.flatness, parameters.flatness, varying.flatness);
    take(d.clearcoat, parameters.clearcoat, varying.clearcoat);
    take(d.clearcoat_gloss, parameters.clearcoat_gloss, varying.clearcoat_gloss);
    return principled(parameters, varying);
}

}  // namespace nicol::scene
