// SPDX-License-Identifier: MIT
#include "import/gltf_models.hpp"

#include <cmath>

#include "material/dielectric.hpp"
#include "material/mixture.hpp"
#include "material/textured.hpp"

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

namespace {

// Roughness up to which a boundary without a diffuse base is smooth. A lobe as narrow as this looks the same.
constexpr double kSmooth = 0.01;
// Least roughness that a texture gives.
constexpr double kLeastOfTexture = 0.01;

}  // namespace

MaterialPtr GlassModel::make(const MaterialMaker& maker) const {
    const double alpha = mean_of(maker.number(glass.alpha), kLeastOfTexture);
    std::vector<double> transmittance = mean_of(maker.color(glass.color));
    for (double& value : transmittance) {
        // Light enters a body and leaves it, and takes the colour once.
        value = glass.share * (glass.is_body ? std::sqrt(value) : value);
    }
    std::vector<double> absorption{0.0};
    if (glass.absorption != glm::dvec3(0.0) && maker.channels.rgb())
        absorption = {glass.absorption.x, glass.absorption.y, glass.absorption.z};
    else if (glass.absorption != glm::dvec3(0.0))
        absorption = {(glass.absorption.x + glass.absorption.y + glass.absorption.z) / 3};
    const FilmParameters film = film_in(glass.film, maker.channels);
    if (glass.share == 1 && alpha <= kSmooth) {
        const DielectricParameters smooth{.specular_transmittance = std::move(transmittance),
                                          .int_ior = glass.index,
                                          .ext_ior = 1,
                                          .absorption = std::move(absorption),
                                          .film = film};
        return glass.is_body ? dielectric(smooth) : thin_dielectric(smooth);
    }
    using Behind = SmoothBoundary::Behind;
    const auto kind = glass.is_body ? FilmTable::Kind::interface : FilmTable::Kind::slab;
    return transmitting(maker.make(reflection), {.behind = glass.is_body ? Behind::body : Behind::slab,
                                                 .eta = glass.index,
                                                 .reflectance = {glass.share},
                                                 .transmittance = std::move(transmittance),
                                                 .absorption = std::move(absorption),
                                                 .alpha = alpha,
                                                 .distribution = Distribution::ggx,
                                                 .film = film_table(film, 1, {glass.index}, kind)});
}

MaterialPtr SpecularModel::make(const MaterialMaker& maker) const {
    return sum(scaled(maker.make(plastic), maker.textures.color(*share)), maker.make(mirror));
}

}  // namespace nicol::scene
