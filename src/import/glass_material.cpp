// SPDX-License-Identifier: MIT
#include "import/glass_material.hpp"

#include <cmath>

#include "material/dielectric.hpp"
#include "material/textured.hpp"

namespace nicol::scene {
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
    if (glass.share == 1 && alpha <= kSmooth) {
        const DielectricParameters smooth{.specular_transmittance = std::move(transmittance),
                                          .int_ior = glass.index,
                                          .ext_ior = 1,
                                          .absorption = std::move(absorption)};
        return glass.is_body ? dielectric(smooth) : thin_dielectric(smooth);
    }
    using Behind = SmoothBoundary::Behind;
    return transmitting(maker.make(reflection), {.behind = glass.is_body ? Behind::body : Behind::slab,
                                                 .eta = glass.index,
                                                 .reflectance = {glass.share},
                                                 .transmittance = std::move(transmittance),
                                                 .absorption = std::move(absorption),
                                                 .alpha = alpha,
                                                 .distribution = Distribution::ggx});
}

}  // namespace nicol::scene
