// SPDX-License-Identifier: MIT
#include "surfaces/photon_rays.hpp"

#include <algorithm>
#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "geometry/beyond_hit.hpp"
#include "geometry/largest_coordinate.hpp"
#include "surfaces/triangle_offset.hpp"

namespace nicol {
namespace {

// Returns the surfaces that block light although the camera does not see them; null: none.
std::unique_ptr<const RayScene> unseen_blockers(const WorldGeometry& geometry) {
    struct Side {
        std::vector<glm::uvec3> triangles;
        std::vector<TriangleNumbers> numbers;
    };
    std::array<Side, 2> sides;  // one-sided, two-sided
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const VertexRange& range = geometry.ranges[batch.range];
        if (range.roles.visible || !PhotonRays::blocks(range)) continue;
        Side& side = sides[batch.two_sided ? 1 : 0];
        side.numbers.push_back({.first = static_cast<std::uint32_t>(side.triangles.size()),
                                .number = static_cast<std::uint32_t>(batch.first)});
        const auto triangles = std::span(geometry.triangles).subspan(batch.first, batch.last - batch.first);
        side.triangles.insert(side.triangles.end(), triangles.begin(), triangles.end());
    }
    if (sides[0].triangles.empty() && sides[1].triangles.empty()) return nullptr;
    std::array<RaySurface, 2> surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i) {
        const auto& [triangles, numbers] = sides[i];
        // Both sides of a two-sided surface have triangles.
        surfaces[i] = {.positions = geometry.positions,
                       .triangles = triangles,
                       .present = presence_of(geometry, numbers, triangles.size()),
                       .front_only = i == 1,
                       .numbers = numbers};
    }
    return std::make_unique<const RayScene>(surfaces);
}

}  // namespace

PhotonRays::PhotonRays(const WorldGeometry& geometry, const SmoothSurfaces& smooth)
    : geometry_(geometry),
      smooth_(smooth),
      some_pass_light_(std::ranges::any_of(
          geometry.ranges, [](const VertexRange& range) { return range.roles.visible && !blocks(range); })),
      unseen_(unseen_blockers(geometry)) {}

bool PhotonRays::blocks(const VertexRange& range) {
    return range.roles.casts_shadows && (range.roles.visible || range.material->smooth_boundary() == nullptr);
}

bool PhotonRays::occluded(const Ray& ray) const {
    if (unseen_ != nullptr && unseen_->occluded(ray)) return true;
    if (!some_pass_light_) return smooth_.occluded(ray);
    Ray rest = ray;
    rest.farthest = before_light(ray.farthest, largest_coordinate(ray.origin));
    while (const std::optional<RayHit> hit = smooth_.intersect(rest)) {
        if (blocks(geometry_.ranges[range_of(geometry_, geometry_.triangles[hit->triangle].x)])) return true;
        rest.nearest = beyond(*hit);
    }
    return false;
}

std::optional<RayHit> PhotonRays::first(const Ray& ray) const {
    std::optional<RayHit> hit = smooth_.intersect(ray);
    if (unseen_ == nullptr) return hit;
    const std::optional<RayHit> unseen = unseen_->intersect(ray);
    return unseen && !(hit && hit->distance <= unseen->distance) ? unseen : hit;
}

double PhotonRays::beyond(const RayHit& hit) const {
    return nicol::beyond(hit, offset_of_triangle(geometry_, hit.triangle));
}

}  // namespace nicol
