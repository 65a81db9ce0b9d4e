// SPDX-License-Identifier: MIT
#include "visibility/point_tracer.hpp"

#include <algorithm>

namespace nicol {

PointTracer::PointTracer(const BakeGeometry& geometry, const DirectionSet& directions,
                         const FormerRefinement* former)
    : directions_(directions),
      former_(former),
      rays_(rays_of(geometry)),
      blockers_(possible_blockers_of(geometry, directions, former == nullptr && !geometry.every_ray)),
      light_(directions) {
    if (former == nullptr) return;
    disturbed_.emplace(directions, former->disturbances);
    for (const ShiftedObject& object : former->shifted) beside_.emplace_back(directions, object.others);
    if (!former->shifted.empty()) nearby_ = NearbyPoints(former->points);
}

std::optional<PointTracer::Former> PointTracer::find(const Point& at) const {
    if (former_ == nullptr) return std::nullopt;
    if (const auto point = former_->points.find(at.origin, at.normal))
        return Former{.point = *point, .disturbed = &*disturbed_};
    for (std::size_t i = 0; i < beside_.size(); ++i) {
        const ShiftedObject& object = former_->shifted[i];
        if (at.given < object.vertices.first || at.given >= object.vertices.last) continue;
        const glm::vec3 before(glm::dvec3(at.origin) - object.shift);
        if (const auto point = nearby_.find(former_->points, before, at.normal))
            return Former{.point = *point, .disturbed = &beside_[i]};
    }
    return std::nullopt;
}

RayCounts PointTracer::trace(const Point& at, std::span<const Seeing> around, std::size_t i, Visibility& seen,
                             glm::vec4& hides) const {
    const glm::vec3& origin = at.origin;
    const glm::vec3& normal = at.normal;
    const auto traced = [&](const std::optional<FormerBits>& known) {
        return blockers_->trace(rays_, origin, normal, i, known, seen);
    };
    RayCounts rays;
    if (const std::optional<Former> point = find(at)) {
        const std::span bits = former_->points.bits(point->point);
        const bool unoccluded = former_->points.unoccluded(point->point);
        thread_local DisturbedBundles bundles;
        if (point->disturbed->find(origin, normal, bundles)) {
            rays = traced(FormerBits{.bits = bits, .disturbed = &bundles, .unoccluded = unoccluded});
        } else {
            std::ranges::copy(bits, seen.at(i).begin());
            seen.set_unoccluded(i, unoccluded);
        }
        if (seen.unoccluded(i) == unoccluded && std::ranges::equal(seen.at(i), bits)) {
            hides = former_->points.hidden(point->point);
            return rays;
        }
    } else if (around.empty()) {
        rays = traced({});
    } else {
        Agreement agreement;
        agreement.find(around, around.size() > 2 ? 1 : around.size(), directions_, normal, i);
        rays = agreement.settle(seen.at(i), blockers_->cones(), traced);
    }
    hides = light_.at(seen, i, normal);
    return rays;
}

}  // namespace nicol
