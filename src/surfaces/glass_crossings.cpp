// SPDX-License-Identifier: MIT
#include "surfaces/glass_crossings.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <glm/geometric.hpp>
#include <span>
#include <utility>
#include <vector>

#include "geometry/beyond_hit.hpp"
#include "material/dielectric.hpp"
#include "surfaces/triangle_offset.hpp"

namespace nicol {

GlassShadows::FirstCrossing first_crossing(const WorldGeometry& geometry, FirstHit intersect,
                                           PassedGlass glass) {
    std::vector<const SmoothBoundary*> boundaries(geometry.triangles.size());
    std::vector<std::uint8_t> passed(geometry.triangles.size());  // 1: of instances that cast no shadows
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const VertexRange& range = geometry.ranges[batch.range];
        const auto first = static_cast<std::ptrdiff_t>(batch.first);
        const auto last = static_cast<std::ptrdiff_t>(batch.last);
        const SmoothBoundary* boundary = range.material->smooth_boundary();
        if (glass == PassedGlass::unbent && boundary != nullptr && boundary->bends() && !boundary->rough())
            boundary = nullptr;
        std::fill(boundaries.begin() + first, boundaries.begin() + last, boundary);
        std::fill(passed.begin() + first, passed.begin() + last, range.roles.casts_shadows ? 0 : 1);
    }
    return [&geometry, intersect = std::move(intersect), boundaries = std::move(boundaries),
            passed = std::move(passed)](Ray ray) -> std::optional<GlassShadows::Crossing> {
        std::optional<RayHit> hit = intersect(ray);
        while (hit && passed[hit->triangle] != 0) {
            ray.nearest = beyond(*hit, offset_of_triangle(geometry, hit->triangle));
            hit = intersect(ray);
        }
        if (!hit) return std::nullopt;
        const glm::uvec3& corners = geometry.triangles[hit->triangle];
        const glm::dvec3 normal = (1 - hit->b1 - hit->b2) * glm::dvec3(geometry.normals[corners.x]) +
                                  hit->b1 * glm::dvec3(geometry.normals[corners.y]) +
                                  hit->b2 * glm::dvec3(geometry.normals[corners.z]);
        const double length = glm::length(normal);
        return GlassShadows::Crossing{.boundary = boundaries[hit->triangle],
                                      .normal = length > 0 ? normal / length : -ray.direction,
                                      .distance = hit->distance,
                                      .offset = offset_of_triangle(geometry, hit->triangle)};
    };
}

std::shared_ptr<const BakeGlass> glass_of(const std::shared_ptr<const WorldGeometry>& geometry) {
    auto out = std::make_shared<BakeGlass>();
    std::vector<TriangleNumbers> numbers;
    std::vector<MaterialPtr> materials;
    for (const TriangleBatch& batch : triangle_batches(*geometry)) {
        const VertexRange& range = geometry->ranges[batch.range];
        const SmoothBoundary* const boundary = range.material->smooth_boundary();
        if (boundary == nullptr || !range.roles.casts_shadows || batch.first == batch.last) continue;
        numbers.push_back({.first = static_cast<std::uint32_t>(out->triangles.size()),
                           .number = static_cast<std::uint32_t>(batch.first)});
        const auto triangles = std::span(geometry->triangles).subspan(batch.first, batch.last - batch.first);
        out->triangles.insert(out->triangles.end(), triangles.begin(), triangles.end());
        out->key += boundary->content_key() + " x " + std::to_string(triangles.size()) + "; ";
        materials.push_back(range.material);
    }
    if (numbers.empty()) return nullptr;
    const RaySurface surface{.positions = geometry->positions,
                             .triangles = out->triangles,
                             .present = presence_of(*geometry, numbers, out->triangles.size()),
                             .numbers = numbers};
    out->surfaces = std::make_shared<const RayScene>(std::span(&surface, 1));
    const auto intersect = [rays = out->surfaces](const Ray& ray) { return rays->intersect(ray); };
    const GlassShadows shadows(out->surfaces, first_crossing(*geometry, intersect, PassedGlass::all));
    // The materials keep their boundaries, which a later change of the geometry's ranges may give up.
    out->transmittance = [shadows, geometry, materials = std::move(materials)](const Ray& ray) {
        return shadows.transmittance(ray);
    };
    return out;
}

}  // namespace nicol
