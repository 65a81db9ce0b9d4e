// SPDX-License-Identifier: MIT
#include "reference/boundary_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "material/microfacet.hpp"
#include "material/reflectance.hpp"
#include "polarization/fresnel.hpp"
#include "shading/rough_boundary.hpp"

namespace nicol {
namespace {

const glm::dvec3 kThrough(1, 1, -1);  // factors that mirror a direction in the surface

// Smallest probability of reflection and of transmission. Facets at other angles than the surface may reflect
// or transmit far more than it would.
constexpr double kLeastShare = 0.1;

}  // namespace

BoundarySampler::BoundarySampler(const SmoothBoundary& boundary, const glm::dvec3& towards_viewer)
    : boundary_(boundary),
      viewer_(towards_viewer),
      side_(towards_viewer.z < 0 ? -1 : 1),
      eta_(side_ < 0 && boundary.behind == SmoothBoundary::Behind::body ? 1 / boundary.eta : boundary.eta) {
    const double reflected = fresnel_reflection(std::min(1.0, std::abs(viewer_.z)), eta_)(0, 0);
    const double transmitted = mean_factor(boundary.transmittance) * (1 - reflected);
    const double sum = transmitted + mean_factor(boundary.reflectance) * reflected;
    transmitted_share_ = std::clamp(sum > 0 ? transmitted / sum : 0.5, kLeastShare, 1 - kLeastShare);
}

glm::dvec3 BoundarySampler::facet(const glm::dvec2& point) const {
    const glm::dvec3 on_front =
        visible_facet(glm::dvec2(boundary_.alpha), {viewer_.x, viewer_.y, side_ * viewer_.z}, point);
    return {on_front.x, on_front.y, side_ * on_front.z};
}

double BoundarySampler::facet_pdf(const glm::dvec3& facet) const {
    const double height = std::abs(viewer_.z);
    return facet_visibility(Distribution::ggx, boundary_.alpha, height) *
           facet_density(Distribution::ggx, boundary_.alpha, side_ * facet.z) *
           std::max(0.0, glm::dot(viewer_, facet)) / height;
}

glm::dvec3 BoundarySampler::sample_reflected(const glm::dvec2& point) const {
    const glm::dvec3 normal = facet(point);
    return glm::normalize(2 * glm::dot(viewer_, normal) * normal - viewer_);
}

double BoundarySampler::reflected_pdf(const glm::dvec3& towards_light) const {
    const glm::dvec3 sum = viewer_ + towards_light;
    const double length = glm::length(sum);
    if (!(length > 0) || !(side_ * sum.z > 0)) return 0;
    const glm::dvec3 normal = sum / length;
    const double cosine = glm::dot(viewer_, normal);
    return cosine > 0 ? facet_pdf(normal) / (4 * cosine) : 0;
}

glm::dvec3 BoundarySampler::sample_transmitted(const glm::dvec2& point) const {
    if (boundary_.behind == SmoothBoundary::Behind::slab) return kThrough * sample_reflected(point);
    const glm::dvec3 normal = facet(point);
    const double cosine = glm::dot(viewer_, normal);
    const double square = eta_ * eta_ - 1 + cosine * cosine;
    // Under total reflection the facet transmits nothing, and the viewer's own side carries no light.
    if (!(square > 0)) return viewer_;
    return glm::normalize((cosine - std::sqrt(square)) * normal - viewer_);
}

double BoundarySampler::transmitted_pdf(const glm::dvec3& towards_light) const {
    if (boundary_.behind == SmoothBoundary::Behind::slab) return reflected_pdf(kThrough * towards_light);
    if (!(towards_light.z * viewer_.z < 0)) return 0;
    const glm::dvec3 normal = facet_between(boundary_, towards_light, viewer_);
    if (normal == glm::dvec3(0.0)) return 0;
    const double to_light = -glm::dot(normal, towards_light);
    const double spread = glm::dot(normal, viewer_) - eta_ * to_light;
    return facet_pdf(normal) * eta_ * eta_ * to_light / (spread * spread);
}

}  // namespace nicol
