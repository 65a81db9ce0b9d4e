// SPDX-License-Identifier: MIT
#include "import/brushed_material.hpp"

#include "material/mixture.hpp"

namespace nicol::scene {

MaterialPtr BrushedModel::make(const MaterialMaker& maker) const {
    const auto made = [&](double across, double along) {
        return maker.make(of({.distribution = Distribution::ggx,
                              .alpha = widened(across, along),
                              .alpha_v = TexturedNumber(across)}));
    };
    const NumberParameter a = maker.number(alpha), s = maker.number(strength);
    if (a.texture && s.texture) return with_roughness(made, a.texture, s.texture);
    if (a.texture) return with_roughness([&](double across) { return made(across, s.value); }, a.texture);
    if (s.texture) return with_roughness([&](double along) { return made(a.value, along); }, s.texture);
    return made(a.value, s.value);
}

MaterialPtr RotatedModel::make(const MaterialMaker& maker) const {
    const MaterialPtr material = maker.make(base);
    return rotated(material, directions ? maker.textures.vector(*directions) : nullptr, angle);
}

}  // namespace nicol::scene
