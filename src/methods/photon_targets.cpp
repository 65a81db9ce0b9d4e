// SPDX-License-Identifier: MIT
#include "methods/photon_targets.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "geometry/box.hpp"

namespace nicol {
namespace {

// Least distance of a ball, in its radii, at which photons are aimed.
constexpr double kFarTarget = 2;

}  // namespace

PhotonTargets::PhotonTargets(const WorldGeometry& geometry, const LinkedSurfaces& surfaces) {
    std::vector<Box> boxes(geometry.ranges.size());
    for (const SurfaceLink& link : surfaces.links())
        boxes[range_of(geometry, geometry.triangles[link.triangle].x)].add(
            glm::dvec3(geometry.positions[surfaces.vertices()[link.receiver]]));
    targets_.resize(boxes.size());
    for (std::size_t range = 0; range < boxes.size(); ++range) {
        const auto& [lower, upper] = boxes[range];
        if (!boxes[range].empty())
            targets_[range] = {.middle = 0.5 * (lower + upper), .radius = 0.5 * glm::length(upper - lower)};
    }
}

std::optional<AimedCone> PhotonTargets::seen_from(std::size_t range, const glm::dvec3& position,
                                                  const Frame& frame) const {
    const auto& [middle, radius] = targets_[range];
    const glm::dvec3 way = middle - position;
    const double distance = glm::length(way);
    if (!(radius > 0) || distance < kFarTarget * radius) return std::nullopt;
    const double sine = radius / distance;
    const AimedCone cone{.axis = glm::normalize(way * frame), .cosine = std::sqrt(1 - sine * sine)};
    if (cone.axis.z <= -sine || !(cone.cosine < 1)) return std::nullopt;
    return cone;
}

}  // namespace nicol
