// SPDX-License-Identifier: MIT
#include "material/microfacet.hpp"

#include <cmath>
#include <numbers>

namespace nicol {
namespace {

// tan2: of the facet's angle, over the square of the roughness along its azimuth. alpha2: the product of the
// roughness along both axes.
double density(Distribution distribution, double alpha2, double tan2, double cos2) {
    const double scale = 1 / (std::numbers::pi * alpha2 * cos2 * cos2);
    if (distribution == Distribution::beckmann) return scale * std::exp(-tan2);
    return scale / ((1 + tan2) * (1 + tan2));
}

// tangent: of the viewing angle, times the roughness along its azimuth.
double visibility(Distribution distribution, double tangent) {
    if (distribution == Distribution::ggx) return 2 / (1 + std::sqrt(1 + tangent * tangent));
    if (tangent <= 1 / 1.6) return 1;
    const double a = 1 / tangent;
    return (3.535 * a + 2.181 * a * a) / (1 + 2.276 * a + 2.577 * a * a);
}

}  // namespace

double facet_density(Distribution distribution, double alpha, double cos_facet) {
    if (cos_facet <= 0) return 0;
    const double cos2 = cos_facet * cos_facet;
    const double alpha2 = alpha * alpha;
    return density(distribution, alpha2, (1 - cos2) / (cos2 * alpha2), cos2);
}

double facet_density(Distribution distribution, const glm::dvec2& alpha, const glm::dvec3& facet) {
    if (facet.z <= 0) return 0;
    const double cos2 = facet.z * facet.z;
    const double x = facet.x / alpha.x;
    const double y = facet.y / alpha.y;
    return density(distribution, alpha.x * alpha.y, (x * x + y * y) / cos2, cos2);
}

double facet_visibility(Distribution distribution, double alpha, double cos_view) {
    if (cos_view <= 0) return 0;
    return visibility(distribution, alpha * std::sqrt(std::fmax(0, 1 - cos_view * cos_view)) / cos_view);
}

double facet_visibility(Distribution distribution, const glm::dvec2& alpha, const glm::dvec3& view) {
    if (view.z <= 0) return 0;
    const double x = alpha.x * view.x;
    const double y = alpha.y * view.y;
    return visibility(distribution, std::sqrt(x * x + y * y) / view.z);
}

double facet_reflection(Distribution distribution, double alpha, const glm::dvec3& light,
                        const glm::dvec3& viewer, const glm::dvec3& half) {
    const double g =
        facet_visibility(distribution, alpha, light.z) * facet_visibility(distribution, alpha, viewer.z);
    return facet_density(distribution, alpha, half.z) * g / (4 * light.z * viewer.z);
}

double facet_reflection(Distribution distribution, const glm::dvec2& alpha, const glm::dvec3& light,
                        const glm::dvec3& viewer, const glm::dvec3& half) {
    const double g =
        facet_visibility(distribution, alpha, light) * facet_visibility(distribution, alpha, viewer);
    return facet_density(distribution, alpha, half) * g / (4 * light.z * viewer.z);
}

}  // namespace nicol
