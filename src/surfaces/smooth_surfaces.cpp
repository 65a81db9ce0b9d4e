// SPDX-License-Identifier: MIT
#include "surfaces/smooth_surfaces.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "material/dielectric.hpp"
#include "material/sampled_terms.hpp"

namespace nicol {
namespace {

Smoothness smoothness_of(const Material& material) {
    if (const SmoothBoundary* const boundary = material.smooth_boundary())
        return boundary->rough() ? Smoothness::rough_boundary : Smoothness::boundary;
    const bool mirrors =
        any_term(material, [](const Material& layer, int term) { return layer.smooth(term); });
    return mirrors ? Smoothness::mirror : Smoothness::none;
}

std::vector<Smoothness> of_triangles(const WorldGeometry& geometry) {
    std::vector<Smoothness> of_ranges;
    for (const VertexRange& range : geometry.ranges) of_ranges.push_back(smoothness_of(*range.material));
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

}  // namespace

void SmoothSurfaces::update(const RefinedSurfaces& surfaces) {
    const WorldGeometry& geometry = surfaces.geometry();
    finding_.run(surfaces.version(), surfaces.material_version(), [&] {
        of_triangles_ = nicol::of_triangles(geometry);
        const auto has = [this](Smoothness smoothness) {
            return std::ranges::find(of_triangles_, smoothness) != of_triangles_.end();
        };
        mirrors_and_glass_ =
            (has(Smoothness::boundary) || has(Smoothness::rough_boundary)) && has(Smoothness::mirror);
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
}

std::shared_ptr<const RayScene> SmoothSurfaces::before_mirrors() const {
    return mirrors_and_glass_ ? rays_ : nullptr;
}

std::optional<RayHit> SmoothSurfaces::intersect(const Ray& ray) const {
    std::optional<RayHit> hit = rays_->intersect(ray);
    if (hit && hit->surface == 1) hit->triangle += one_sided_;
    return hit;
}

}  // namespace nicol
