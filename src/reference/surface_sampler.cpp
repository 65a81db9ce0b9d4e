// SPDX-License-Identifier: MIT
#include "reference/surface_sampler.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numbers>

#include "material/microfacet.hpp"

namespace nicol {
namespace {

using std::numbers::pi;

// Smallest width of a sampled lobe. Narrower lobes are sampled as if they had this width.
constexpr double kNarrowest = 1e-3;

glm::dvec3 cosine_sample(const glm::dvec2& point) {
    const double radius = std::sqrt(point.x);
    const double phi = 2 * pi * point.y;
    return {radius * std::cos(phi), radius * std::sin(phi), std::sqrt(1 - point.x)};
}

double facet_pdf(const glm::dvec2& roughness, const glm::dvec3& viewer, const glm::dvec3& light) {
    const glm::dvec3 sum = viewer + light;
    const double length = glm::length(sum);
    if (!(length > 0) || !(sum.z > 0)) return 0;
    // Density of the visible facets, G1 D (v.h) / v.z, times the Jacobian of reflecting, 1 / (4 v.h).
    return facet_visibility(Distribution::ggx, roughness, viewer) *
           facet_density(Distribution::ggx, roughness, sum / length) / (4 * viewer.z);
}

}  // namespace

SurfaceSampler::SurfaceSampler(const Material& material) {
    bool wide = false;
    for (int t = 0; t < material.terms(); ++t) {
        const double width = material.lobe_width(t);
        wide = wide || !(width < 1);
        const glm::dvec2 roughness = glm::max(material.lobe_widths(t), kNarrowest);
        const auto same = [&](const Lobe& lobe) { return lobe.roughness == roughness; };
        if (width < 1 && std::ranges::none_of(lobes_, same)) lobes_.push_back({roughness, 0});
    }
    if (lobes_.empty()) return;
    // A diffuse base gets half of the samples, although its share of s0 is mostly larger, because s1 and s2
    // come from the lobes. Other materials get some cosine-weighted samples, too, because a measured lobe may
    // extend far from its peak.
    cosine_share_ = wide ? 0.5 : 0.1;
    for (Lobe& lobe : lobes_) lobe.share = (1 - cosine_share_) / static_cast<double>(lobes_.size());
}

glm::dvec3 SurfaceSampler::sample(const glm::dvec3& towards_viewer, const glm::dvec2& point) const {
    // The first coordinate chooses a lobe or the hemisphere; the coordinate's remainder samples the choice.
    double x = point.x;
    for (const Lobe& lobe : lobes_) {
        if (x < lobe.share) {
            const glm::dvec3 half = visible_facet(lobe.roughness, towards_viewer, {x / lobe.share, point.y});
            return glm::normalize(2 * glm::dot(towards_viewer, half) * half - towards_viewer);
        }
        x -= lobe.share;
    }
    return cosine_sample({std::min(1.0, x / cosine_share_), point.y});
}

double SurfaceSampler::pdf(const glm::dvec3& towards_viewer, const glm::dvec3& towards_light) const {
    double sum = cosine_share_ * std::max(0.0, towards_light.z) / pi;
    for (const Lobe& lobe : lobes_)
        sum += lobe.share * facet_pdf(lobe.roughness, towards_viewer, towards_light);
    return sum;
}

}  // namespace nicol
