// SPDX-License-Identifier: MIT
#include "surfaces/smooth_surfaces.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "material/dielectric.hpp"
#include "material/followed_terms.hpp"

namespace nicol {

Smoothness smoothness_of(const Material& material, bool lobes) {
    if (const SmoothBoundary* const boundary = material.smooth_boundary())
        return boundary->rough() ? Smoothness::rough_boundary : Smoothness::boundary;
    if (lobes && follows_lobes(material)) return Smoothness::lobes;
    const bool mirrors =
        any_term(material, [](const Material& layer, int term) { return layer.smooth(term); });
    return mirrors ? Smoothness::mirror : Smoothness::none;
}

namespace {

std::vector<Smoothness> of_triangles(const WorldGeometry& geometry, bool lobes) {
    std::vector<Smoothness> of_ranges;
    for (const VertexRange& range : geometry.ranges)
        of_ranges.push_back(smoothness_of(*range.material, lobes));
    std::vector<Smoothness> out;
    if (std::ranges::all_of(of_ranges, [](Smoothness is) { return is == Smoothness::none; })) return out;
    out.resize(geometry.triangles.size());
    for (const TriangleBatch& batch : triangle_batches(geometry))
        std::fill(out.begin() + static_cast<std::ptrdiff_t>(batch.first),
                  out.begin() + static_cast<std::ptrdiff_t>(batch.last), of_ranges[batch.range]);
    return out;
}

// Returns what GlassShadows needs to know. The geometry must outlive the result.
GlassShadows::FirstCrossing first_crossing(const WorldGeometry& geometry,
                                           std::shared_ptr<const DrawnTriangles> rays) {
    std::vector<const SmoothBoundary*> boundaries(geometry.triangles.size());
    std::vector<std::uint8_t> passed(geometry.triangles.size());  // 1: of instances that cast no shadows
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const VertexRange& range = geometry.ranges[batch.range];
        const auto first = static_cast<std::ptrdiff_t>(batch.first);
        const auto last = static_cast<std::ptrdiff_t>(batch.last);
        std::fill(boundaries.begin() + first, boundaries.begin() + last, range.material->smooth_boundary());
        std::fill(passed.begin() + first, passed.begin() + last, range.roles.casts_shadows ? 0 : 1);
    }
    return [&geometry, rays = std::move(rays), boundaries = std::move(boundaries),
            passed = std::move(passed)](Ray ray) -> std::optional<GlassShadows::Crossing> {
        std::optional<RayHit> hit = rays->intersect(ray);
        while (hit && passed[hit->triangle] != 0) {
            ray.nearest = hit->distance * (1 + kRayOffset);
            hit = rays->intersect(ray);
        }
        if (!hit) return std::nullopt;
        const glm::uvec3& corners = geometry.triangles[hit->triangle];
        const glm::dvec3 normal = (1 - hit->b1 - hit->b2) * glm::dvec3(geometry.normals[corners.x]) +
                                  hit->b1 * glm::dvec3(geometry.normals[corners.y]) +
                                  hit->b2 * glm::dvec3(geometry.normals[corners.z]);
        const double length = glm::length(normal);
        return GlassShadows::Crossing{
            .boundary = boundaries[hit->triangle],
            .normal = length > 0 ? normal / length : -ray.direction,
            .distance = hit->distance,
            .offset = ray_offset({geometry.positions[corners.x], geometry.positions[corners.y],
                                  geometry.positions[corners.z]})};
    };
}

}  // namespace

void SmoothSurfaces::update(const RefinedSurfaces& surfaces, DrawnRays& rays, bool lobes) {
    const WorldGeometry& geometry = surfaces.geometry();
    finding_.run(surfaces.version(), surfaces.material_version(), lobes, [&] {
        of_triangles_ = nicol::of_triangles(geometry, lobes);
        const auto has = [this](Smoothness smoothness) {
            return std::ranges::find(of_triangles_, smoothness) != of_triangles_.end();
        };
        mirrors_ = has(Smoothness::mirror) || has(Smoothness::lobes);
        glass_too_ = mirrors_ && (has(Smoothness::boundary) || has(Smoothness::rough_boundary));
    });
    tracing_.run(surfaces.version(), any(), [&] {
        rays_.reset();
        if (any()) rays_ = rays.get(surfaces);
    });
    shading_.run(surfaces.version(), surfaces.material_version(), [&] {
        glass_.reset();
        const auto transmits = [](Smoothness is) {
            return is == Smoothness::boundary || is == Smoothness::rough_boundary;
        };
        if (std::ranges::any_of(of_triangles_, transmits))
            glass_ = std::make_shared<const GlassShadows>(rays_->scene(), first_crossing(geometry, rays_));
    });
}

std::shared_ptr<const RayScene> SmoothSurfaces::before_mirrors() const {
    return glass_too_ ? rays_->scene() : nullptr;
}

std::optional<RayHit> SmoothSurfaces::intersect(const Ray& ray) const {
    return rays_->intersect(ray);
}

}  // namespace nicol
