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

// Returns the alpha masks of the triangles from `first` on.
Presence presence_from(const WorldGeometry& geometry, std::uint32_t first) {
    Presence all = presence_of(geometry);
    if (!all) return {};
    return [all = std::move(all), first](std::uint32_t triangle, float b1, float b2) {
        return all(first + triangle, b1, b2);
    };
}

// Returns the first hit of a ray, with an index into all triangles.
std::optional<RayHit> first_hit(const RayScene& rays, std::uint32_t one_sided, const Ray& ray) {
    std::optional<RayHit> hit = rays.intersect(ray);
    if (hit && hit->surface == 1) hit->triangle += one_sided;
    return hit;
}

// Returns what GlassShadows needs to know. The geometry must outlive the result.
GlassShadows::FirstCrossing first_crossing(const WorldGeometry& geometry,
                                           std::shared_ptr<const RayScene> rays, std::uint32_t one_sided) {
    std::vector<const SmoothBoundary*> boundaries(geometry.triangles.size());
    for (const TriangleBatch& batch : triangle_batches(geometry))
        std::fill(boundaries.begin() + static_cast<std::ptrdiff_t>(batch.first),
                  boundaries.begin() + static_cast<std::ptrdiff_t>(batch.last),
                  geometry.ranges[batch.range].material->smooth_boundary());
    return [&geometry, rays = std::move(rays), one_sided,
            boundaries = std::move(boundaries)](const Ray& ray) -> std::optional<GlassShadows::Crossing> {
        const std::optional<RayHit> hit = first_hit(*rays, one_sided, ray);
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

void SmoothSurfaces::update(const RefinedSurfaces& surfaces, bool lobes) {
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
        if (!any()) return;
        one_sided_ = static_cast<std::uint32_t>(geometry.one_sided);
        const std::span triangles(geometry.triangles);
        const RaySurface sides[] = {{.positions = geometry.positions,
                                     .triangles = triangles.first(one_sided_),
                                     .present = presence_of(geometry)},
                                    {.positions = geometry.positions,
                                     .triangles = triangles.subspan(one_sided_),
                                     .present = presence_from(geometry, one_sided_),
                                     .front_only = true}};
        rays_ = std::make_shared<const RayScene>(sides);
    });
    shading_.run(surfaces.version(), surfaces.material_version(), [&] {
        glass_.reset();
        const auto transmits = [](Smoothness is) {
            return is == Smoothness::boundary || is == Smoothness::rough_boundary;
        };
        if (std::ranges::any_of(of_triangles_, transmits))
            glass_ = std::make_shared<const GlassShadows>(rays_, first_crossing(geometry, rays_, one_sided_));
    });
}

std::shared_ptr<const RayScene> SmoothSurfaces::before_mirrors() const {
    return glass_too_ ? rays_ : nullptr;
}

std::optional<RayHit> SmoothSurfaces::intersect(const Ray& ray) const {
    return first_hit(*rays_, one_sided_, ray);
}

}  // namespace nicol
