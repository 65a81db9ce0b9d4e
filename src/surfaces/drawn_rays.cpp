// SPDX-License-Identifier: MIT
#include "surfaces/drawn_rays.hpp"

#include <span>
#include <utility>
#include <vector>

namespace nicol {
namespace {

// Returns the alpha masks of the triangles from `first` on.
Presence presence_from(const WorldGeometry& geometry, std::uint32_t first) {
    Presence all = presence_of(geometry);
    if (!all) return {};
    return [all = std::move(all), first](std::uint32_t triangle, float b1, float b2) {
        return all(first + triangle, b1, b2);
    };
}

}  // namespace

DrawnTriangles::DrawnTriangles(const WorldGeometry& geometry, Masks masks)
    : one_sided_(static_cast<std::uint32_t>(geometry.one_sided)) {
    std::vector<glm::uvec3> room;
    const std::span triangles = shown_triangles(geometry, room);
    const bool pass = masks == Masks::pass;
    const RaySurface sides[] = {{.positions = geometry.positions,
                                 .triangles = triangles.first(one_sided_),
                                 .present = pass ? presence_of(geometry) : Presence()},
                                {.positions = geometry.positions,
                                 .triangles = triangles.subspan(one_sided_),
                                 .present = pass ? presence_from(geometry, one_sided_) : Presence(),
                                 .front_only = true}};
    scene_ = std::make_shared<const RayScene>(sides);
}

std::optional<RayHit> DrawnTriangles::intersect(const Ray& ray) const {
    std::optional<RayHit> hit = scene_->intersect(ray);
    if (hit && hit->surface == 1) hit->triangle += one_sided_;
    return hit;
}

void DrawnTriangles::intersect(std::span<const Ray> rays, std::span<std::optional<RayHit>> hits) const {
    scene_->intersect(rays, hits);
    for (std::optional<RayHit>& hit : hits)
        if (hit && hit->surface == 1) hit->triangle += one_sided_;
}

std::uint16_t DrawnTriangles::intersect(const RayPacket& packet, std::uint16_t active,
                                        HitPacket& hits) const {
    const std::uint16_t found = scene_->intersect(packet, active, hits);
    for (std::size_t i = 0; i < RayPacket::kRays; ++i)
        if ((found >> i & 1) != 0 && hits.surface[i] == 1) hits.triangle[i] += one_sided_;
    return found;
}

std::shared_ptr<const DrawnTriangles> DrawnRays::get(const RefinedSurfaces& surfaces) {
    std::shared_ptr<const DrawnTriangles> triangles = shared_.lock();
    if (triangles && version_ == surfaces.version()) return triangles;
    triangles = std::make_shared<const DrawnTriangles>(surfaces.geometry(), DrawnTriangles::Masks::pass);
    shared_ = triangles;
    version_ = surfaces.version();
    return triangles;
}

}  // namespace nicol
