// SPDX-License-Identifier: MIT
#include "material/microfacet.hpp"

#include <cmath>
#include <numbers>

namespace nicol {

double facet_density(Distribution distribution, double alpha, double cos_facet) {
    if (cos_facet <= 0) return 0;
    const double cos2 = cos_facet * cos_facet;
    const double alpha2 = alpha * alpha;
    const double tan2_over_alpha2 = (1 - cos2) / (cos2 * alpha2);
    const double scale = 1 / (std::numbers::pi * alpha2 * cos2 * cos2);
    if (distribution == Distribution::beckmann) return scale * std::exp(-tan2_over_alpha2);
    return scale / ((1 + tan2_over_alpha2) * (1 + tan2_over_alpha2));
}

double facet_visibility(Distribution distribution, double alpha, double cos_view) {
    if (cos_view <= 0) return 0;
    const double tangent = std::sqrt(std::fmax(0, 1 - cos_view * cos_view)) / cos_view;
    if (distribution == Distribution::ggx) {
        return 2 / (1 + std::sqrt(1 + alpha * alpha * tangent * tangent));
    }
    if (alpha * tangent <= 1 / 1.6) return 1;
    const double a = 1 / (alpha * tangent);
    return (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

double facet_reflection(Distribution distribution, double alpha, const glm::dvec3& light,
                        const glm::dvec3& viewer, const glm::dvec3& half) {
    const double g =
        facet_visibility(distribution, alpha, light.z) * facet_visibility(distribution, alpha, viewer.z);
    return facet_density(distribution, alpha, half.z) * g / (4 * light.z * viewer.z);
}

}  // namespace nicol
