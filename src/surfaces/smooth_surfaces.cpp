// SPDX-License-Identifier: MIT
#include "surfaces/smooth_surfaces.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <span>

#include "material/dielectric.hpp"
#include "material/followed_terms.hpp"
#include "surfaces/glass_crossings.hpp"
#include "surfaces/open_triangles.hpp"

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

// Returns 1 for each smooth triangle whose front is open.
std::vector<std::uint8_t> open_among(const WorldGeometry& geometry,
                                     std::span<const Smoothness> of_triangles) {
    std::vector<std::uint8_t> out(of_triangles.size());
    if (of_triangles.empty()) return out;
    const OpenTriangles triangles(geometry.positions);
    tbb::parallel_for(std::size_t{0}, out.size(), [&](std::size_t t) {
        if (of_triangles[t] != Smoothness::none) out[t] = triangles.open(geometry.triangles[t]) ? 1 : 0;
    });
    return out;
}

// Returns 1 for each range of smooth glass.
std::vector<std::uint8_t> smooth_glass(const WorldGeometry& geometry) {
    std::vector<std::uint8_t> glass;
    glass.reserve(geometry.ranges.size());
    for (const VertexRange& range : geometry.ranges) {
        // Rays pass masked triangles, which textures make.
        const bool whole = range.material->variation() == nullptr;
        glass.push_back(whole && smoothness_of(*range.material, false) == Smoothness::boundary ? 1 : 0);
    }
    return glass;
}

}  // namespace

void SmoothSurfaces::update(const RefinedSurfaces& surfaces, DrawnRays& rays, bool lobes) {
    const WorldGeometry& geometry = surfaces.geometry();
    finding_.run(surfaces.version(), surfaces.material_version(), lobes, [&] {
        of_triangles_ = nicol::of_triangles(geometry, lobes);
        open_ = open_among(geometry, of_triangles_);
        const std::vector<std::uint8_t> glass = smooth_glass(geometry);
        finding_convex_.run(surfaces.version(), glass, [&] { convex_ = ConvexBodies(geometry, glass); });
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
        unbent_glass_.reset();
        version_ = new_version();
        const auto transmits = [](Smoothness is) {
            return is == Smoothness::boundary || is == Smoothness::rough_boundary;
        };
        if (std::ranges::none_of(of_triangles_, transmits)) return;
        const auto glass = [&](PassedGlass passed) {
            const auto intersect = [rays = rays_](const Ray& ray) { return rays->intersect(ray); };
            return std::make_shared<const GlassShadows>(rays_->scene(),
                                                        first_crossing(geometry, intersect, passed));
        };
        glass_ = glass(PassedGlass::all);
        unbent_glass_ = glass(PassedGlass::unbent);
    });
}

std::shared_ptr<const RayScene> SmoothSurfaces::before_mirrors() const {
    return glass_too_ ? rays_->scene() : nullptr;
}

}  // namespace nicol
