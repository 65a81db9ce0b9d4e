// SPDX-License-Identifier: MIT
#include "transfer/surface_points.hpp"

#include <glm/geometric.hpp>
#include <span>
#include <utility>

namespace nicol {

/// Triangles of a geometry that rays meet.
class SurfacePoints::Triangles {
public:
    Triangles(const BakeGeometry& geometry, std::span<const std::uint32_t> triangles)
        : numbers_(triangles), corners_(corners_of(geometry, triangles)), rays_(rays_of(geometry)) {}

    [[nodiscard]] std::optional<RayHit> intersect(const Ray& ray) const {
        std::optional<RayHit> hit = rays_.intersect(ray);
        if (hit) hit->triangle = numbers_[hit->triangle];
        return hit;
    }

private:
    static std::vector<glm::uvec3> corners_of(const BakeGeometry& geometry,
                                              std::span<const std::uint32_t> triangles) {
        std::vector<glm::uvec3> out;
        out.reserve(triangles.size());
        for (const std::uint32_t triangle : triangles) out.push_back(geometry.triangles[triangle]);
        return out;
    }
    [[nodiscard]] RayScene rays_of(const BakeGeometry& geometry) const {
        Presence present;
        if (geometry.present) {
            present = [numbers = numbers_, &all = geometry.present](std::uint32_t triangle, float b1,
                                                                    float b2) {
                return all(numbers[triangle], b1, b2);
            };
        }
        const RaySurface surface{
            .positions = geometry.positions, .triangles = corners_, .present = std::move(present)};
        return RayScene(std::span(&surface, 1));
    }

    std::span<const std::uint32_t> numbers_;
    std::vector<glm::uvec3> corners_;
    RayScene rays_;
};

SurfacePoints::SurfacePoints(const BakeGeometry& geometry, const TriangleSides& sides)
    : geometry_(geometry), fronts_(std::make_unique<const Triangles>(geometry, sides.fronts)) {
    if (!sides.backs.empty()) backs_ = std::make_unique<const Triangles>(geometry, sides.backs);
}

SurfacePoints::~SurfacePoints() = default;

std::optional<RayHit> SurfacePoints::find(const Ray& ray) const {
    std::optional<RayHit> hit = fronts_->intersect(ray);
    if (!hit || faces(*hit, ray.direction)) return hit;
    if (!backs_) return std::nullopt;
    // The back of a two-sided surface lies in the same place.
    constexpr double around = 1e-5;
    Ray there = ray;
    there.nearest = (1 - around) * hit->distance;
    there.farthest = (1 + around) * hit->distance;
    hit = backs_->intersect(there);
    if (!hit || faces(*hit, ray.direction)) return hit;
    return std::nullopt;
}

bool SurfacePoints::faces(const RayHit& hit, const glm::dvec3& direction) const {
    const glm::uvec3& corners = geometry_.triangles[hit.triangle];
    const glm::dvec3 first(geometry_.positions[corners.x]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(geometry_.positions[corners.y]) - first,
                                         glm::dvec3(geometry_.positions[corners.z]) - first);
    return glm::dot(normal, direction) < 0;
}

}  // namespace nicol
