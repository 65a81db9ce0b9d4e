// SPDX-License-Identifier: MIT
#include "scene_variant.hpp"

namespace {

nicol_spectrum colours(std::uint32_t channels, float first, float step) {
    nicol_spectrum spectrum = NICOL_SPECTRUM_INIT;
    spectrum.count = channels;
    for (std::uint32_t c = 0; c < channels; ++c)
        spectrum.values[c] = first + step * static_cast<float>(c % 4);
    return spectrum;
}

Environment sky(nicol_context context, std::uint32_t channels, bool polarized) {
    nicol_sky wanted = NICOL_SKY_INIT;
    if (!polarized) wanted.dop_max = 0;
    wanted.sun_direction[0] = 0.7F;
    wanted.sun_direction[1] = 0.35F;
    wanted.sun_direction[2] = -0.6F;
    wanted.radiance = colours(channels, 0.95F, -0.2F);
    nicol_environment handle = nullptr;
    check(nicol_environment_create_sky(context, &wanted, &handle));
    return Environment(handle);
}

Material surface(nicol_context context, std::uint32_t channels, bool polarizing) {
    const nicol_spectrum colour = colours(channels, 0.6F, -0.15F);
    nicol_material handle = nullptr;
    if (polarizing) {
        nicol_pplastic plastic = NICOL_PPLASTIC_INIT;
        plastic.diffuse_reflectance = colour;
        plastic.alpha = 0.3F;
        check(nicol_material_create_pplastic(context, &plastic, &handle));
    } else {
        check(nicol_material_create_diffuse(context, &colour, &handle));
    }
    return Material(handle);
}

}  // namespace

void apply_variant(Stage& stage, SceneVariant variant) {
    if (variant == SceneVariant::original) return;
    std::uint32_t channels = 0;
    check(nicol_scene_get_channels(stage.scene(), &channels));
    const bool polarized = variant == SceneVariant::polarized;
    stage.set_light(sky(stage.context(), channels, polarized));
    stage.set_material(surface(stage.context(), channels, polarized).get());
}
