// SPDX-License-Identifier: MIT
#include "visibility/point_tracer.hpp"

#include <algorithm>

namespace nicol {

PointTracer::PointTracer(const BakeGeometry& geometry, const DirectionSet& directions,
                         const FormerRefinement* former)
    : directions_(directions),
      former_(former),
      rays_(rays_of(geometry)),
      blockers_(geometry, directions, former == nullptr && !geometry.every_ray),
      light_(directions) {
    if (former != nullptr) disturbed_.emplace(directions, former->disturbances);
}

RayCounts PointTracer::trace(const glm::vec3& origin, const glm::vec3& normal, std::span<const Seeing> ends,
                             std::size_t i, Visibility& seen, glm::vec4& hides) const {
    DisturbedBundles bundles;
    Agreement agreement;
    std::optional<FormerBits> known;
    std::optional<std::size_t> point;
    if (former_ != nullptr) point = former_->points.find(origin, normal);
    if (point) {
        if (!disturbed_->find(origin, normal, bundles)) {
            std::ranges::copy(former_->points.bits(*point), seen.at(i).begin());
            seen.set_unoccluded(i, former_->points.unoccluded(*point));
            hides = former_->points.hidden(*point);
            return {};
        }
        known = {.bits = former_->points.bits(*point), .disturbed = &bundles};
    } else if (!ends.empty()) {
        agreement.find(ends, ends.size(), directions_, normal, i);
        known = {.bits = agreement.bits, .disturbed = &agreement.traced};
    }
    RayCounts rays = blockers_.trace(rays_, origin, normal, i, known, seen);
    if (!point && !ends.empty()) {
        rays.skipped += agreement.spared;
        if (!agreement.confirmed(seen.at(i))) {
            std::ranges::fill(seen.at(i), 0U);
            const RayCounts all = blockers_.trace(rays_, origin, normal, i, {}, seen);
            rays = {.traced = rays.traced + all.traced, .skipped = all.skipped};
        }
    }
    hides = light_.at(seen, i, normal);
    return rays;
}

}  // namespace nicol
