// SPDX-License-Identifier: MIT
#include "material/microfacet.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace nicol {
namespace {

// Returns a unit vector with this z; isotropic facets do not depend on its x and y.
glm::dvec3 direction(double z) {
    return {std::sqrt(std::fmax(0, 1 - z * z)), 0, z};
}

}  // namespace

double facet_density(Distribution distribution, double alpha, double cos_facet) {
    return facet_density(distribution, glm::dvec2(alpha), direction(cos_facet));
}

double facet_density(Distribution distribution, const glm::dvec2& alpha, const glm::dvec3& facet) {
    if (facet.z <= 0) return 0;
    double out = 0;
    density({distribution, alpha.x, alpha.y}, components(facet), 1.0, out);
    return out;
}

double facet_visibility(Distribution distribution, double alpha, double cos_view) {
    return facet_visibility(distribution, glm::dvec2(alpha), direction(cos_view));
}

double facet_visibility(Distribution distribution, const glm::dvec2& alpha, const glm::dvec3& view) {
    if (view.z <= 0) return 0;
    double out = 0;
    visibility_over_cosine({distribution, alpha.x, alpha.y}, components(view), out);
    return out * view.z;
}

// If space is stretched until the roughness is 1, the facets are a hemisphere, whose reflections of the
// viewer fill a cap of the sphere uniformly.
glm::dvec3 visible_facet(const glm::dvec2& alpha, const glm::dvec3& view, const glm::dvec2& point) {
    const glm::dvec3 stretched = glm::normalize(view * glm::dvec3(alpha, 1));
    const double z = (1 - point.x) * (1 + stretched.z) - stretched.z;
    const double radius = std::sqrt(std::fmax(0, 1 - z * z));
    const double phi = 2 * std::numbers::pi * point.y;
    const glm::dvec3 half = glm::dvec3(radius * std::cos(phi), radius * std::sin(phi), z) + stretched;
    return glm::normalize(half * glm::dvec3(alpha, 1));
}

}  // namespace nicol
