// SPDX-License-Identifier: MIT
#include "surfaces/geometry.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <glm/geometric.hpp>
#include <iterator>
#include <optional>
#include <utility>

namespace nicol {
namespace {

/// Texture coordinates and colours of a triangle's corners, those that the geometry has.
struct CornerValues {
    std::optional<std::array<glm::vec2, 3>> texcoords;
    std::optional<std::array<glm::vec3, 3>> colors;
};

CornerValues corners_of(const WorldGeometry& geometry, std::size_t triangle) {
    CornerValues out;
    if (!geometry.texcoords.empty()) out.texcoords = geometry.texcoords[triangle];
    if (!geometry.colors.empty()) out.colors = geometry.colors[triangle];
    return out;
}

// Returns whether the material of a range of vertices or triangles has an alpha mask.
constexpr auto has_mask = [](const auto& range) { return opacity_of(*range.material) != nullptr; };

bool present(const Material& material, const CornerValues& corners, float b1, float b2, float threshold) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr || variation->opacity == nullptr) return true;
    const TexturePoint point =
        texture_point({1 - b1 - b2, b1, b2}, corners.texcoords ? &*corners.texcoords : nullptr,
                      corners.colors ? &*corners.colors : nullptr);
    return variation->present(point, threshold);
}

}  // namespace

std::size_t range_of(const WorldGeometry& geometry, std::size_t vertex) {
    const auto found = std::ranges::upper_bound(geometry.ranges, vertex, {}, &VertexRange::last);
    return static_cast<std::size_t>(found - geometry.ranges.begin());
}

std::vector<TriangleBatch> triangle_batches(const WorldGeometry& geometry) {
    std::vector<TriangleBatch> batches;
    for (std::size_t i = 0; i < geometry.triangles.size(); ++i) {
        const std::size_t vertex = geometry.triangles[i].x;
        const VertexRange* const known = batches.empty() ? nullptr : &geometry.ranges[batches.back().range];
        if (known == nullptr || vertex < known->first || vertex >= known->last)
            batches.push_back({.range = range_of(geometry, vertex),
                               .two_sided = i >= geometry.one_sided,
                               .first = i,
                               .last = i});
        batches.back().last = i + 1;
    }
    return batches;
}

bool has_masks(const WorldGeometry& geometry) {
    return std::ranges::any_of(geometry.ranges, has_mask);
}

bool is_present(const WorldGeometry& geometry, std::uint32_t triangle, float b1, float b2, float threshold) {
    const VertexRange& range = geometry.ranges[range_of(geometry, geometry.triangles[triangle].x)];
    return !has_mask(range) || present(*range.material, corners_of(geometry, triangle), b1, b2, threshold);
}

Presence presence_of(const WorldGeometry& geometry) {
    if (!has_masks(geometry)) return {};
    return [&geometry](std::uint32_t triangle, float b1, float b2) {
        const VertexRange& range = geometry.ranges[range_of(geometry, geometry.triangles[triangle].x)];
        return present(*range.material, corners_of(geometry, triangle), b1, b2,
                       threshold_at(range.instance, b1, b2));
    };
}

Presence presence_of(const WorldGeometry& geometry, std::span<const TriangleNumbers> numbers,
                     std::size_t triangles) {
    struct Run {
        std::uint32_t first;
        MaterialPtr material;
        std::uint32_t instance;
    };
    std::vector<Run> runs;
    for (const TriangleNumbers& run : numbers) {
        const VertexRange& range = geometry.ranges[range_of(geometry, geometry.triangles[run.number].x)];
        runs.push_back({.first = run.first, .material = range.material, .instance = range.instance});
    }
    if (std::ranges::none_of(runs, has_mask)) return {};
    std::vector<CornerValues> corners;
    for (std::size_t r = 0; r < numbers.size(); ++r) {
        const std::size_t end = r + 1 < numbers.size() ? numbers[r + 1].first : triangles;
        for (std::size_t t = numbers[r].first; t < end; ++t)
            corners.push_back(corners_of(geometry, numbers[r].number + (t - numbers[r].first)));
    }
    return
        [runs = std::move(runs), corners = std::move(corners)](std::uint32_t triangle, float b1, float b2) {
            const Run& run = *std::prev(std::ranges::upper_bound(runs, triangle, {}, &Run::first));
            return present(*run.material, corners[triangle], b1, b2, threshold_at(run.instance, b1, b2));
        };
}

std::vector<std::uint8_t> receivers_of(const WorldGeometry& geometry) {
    const auto receives = [](const VertexRange& range) { return range.roles.receives_shadows; };
    if (std::ranges::all_of(geometry.ranges, receives)) return {};
    std::vector<std::uint8_t> out(geometry.positions.size(), 1);
    for (const VertexRange& range : geometry.ranges)
        if (!receives(range))
            std::fill(out.begin() + static_cast<std::ptrdiff_t>(range.first),
                      out.begin() + static_cast<std::ptrdiff_t>(range.last), std::uint8_t{0});
    return out;
}

std::span<const glm::uvec3> shown_triangles(const WorldGeometry& geometry, std::vector<glm::uvec3>& room) {
    const auto visible = [](const VertexRange& range) { return range.roles.visible; };
    if (std::ranges::all_of(geometry.ranges, visible)) return geometry.triangles;
    room = geometry.triangles;
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        if (visible(geometry.ranges[batch.range])) continue;
        for (glm::uvec3& triangle : std::span(room).subspan(batch.first, batch.last - batch.first))
            triangle = glm::uvec3(triangle.x);
    }
    return room;
}

std::size_t find_visible(const WorldGeometry& geometry, const Projection& projection,
                         std::vector<std::uint8_t>& visible) {
    using Range = tbb::blocked_range<std::size_t>;
    constexpr std::size_t grain = 4096;
    const std::size_t vertices = geometry.positions.size();
    // Bits for the sides of the view that each vertex is outside of.
    std::vector<std::uint8_t> outside(vertices);
    visible.resize(vertices);
    const glm::mat4 clip(projection.world_to_clip);
    const glm::vec2 side = 1.0F + glm::vec2(projection.pixel) / 2.0F;
    tbb::parallel_for(Range(0, vertices, grain), [&](const Range& range) {
        for (std::size_t v = range.begin(); v < range.end(); ++v) {
            const glm::vec4 p = clip * glm::vec4(geometry.positions[v], 1);
            outside[v] = static_cast<std::uint8_t>(
                (p.x < -side.x * p.w ? 1 : 0) | (p.x > side.x * p.w ? 2 : 0) | (p.y < -side.y * p.w ? 4 : 0) |
                (p.y > side.y * p.w ? 8 : 0) | (p.z < 0 ? 16 : 0) | (p.z > p.w ? 32 : 0));
            visible[v] = 0;
        }
    });

    const glm::vec3 eye(projection.view.eye);
    const glm::vec3 backward(-projection.view.forward);
    tbb::parallel_for(Range(0, geometry.triangles.size(), grain), [&](const Range& range) {
        for (std::size_t i = range.begin(); i < range.end(); ++i) {
            const glm::uvec3& t = geometry.triangles[i];
            if ((outside[t.x] & outside[t.y] & outside[t.z]) != 0) continue;
            const glm::vec3& a = geometry.positions[t.x];
            const glm::vec3 normal = glm::cross(geometry.positions[t.y] - a, geometry.positions[t.z] - a);
            const glm::vec3 towards = projection.view.orthographic ? backward : eye - a;
            // Edge-on triangles count as facing, because rounding here must not drop triangles that the
            // rasteriser keeps.
            const float facing = glm::dot(normal, towards);
            if (facing < 0 &&
                facing * facing > 1e-8F * glm::dot(normal, normal) * glm::dot(towards, towards)) {
                continue;
            }
            // Neighbouring triangles share vertices, and another thread may process them.
            for (glm::length_t corner = 0; corner < 3; ++corner) {
                std::atomic_ref(visible[t[corner]]).store(1, std::memory_order_relaxed);
            }
        }
    });
    for (const VertexRange& range : geometry.ranges)
        if (!range.roles.visible)
            std::fill(visible.begin() + static_cast<std::ptrdiff_t>(range.first),
                      visible.begin() + static_cast<std::ptrdiff_t>(range.last), std::uint8_t{0});
    return static_cast<std::size_t>(std::count(visible.begin(), visible.end(), std::uint8_t{0}));
}

}  // namespace nicol
