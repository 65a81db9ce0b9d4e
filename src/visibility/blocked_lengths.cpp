// SPDX-License-Identifier: MIT
#include "visibility/blocked_lengths.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>

#include "simd/dispatch.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

// Largest number of vertices, and of blocked rays per vertex, that are followed to their hit points.
constexpr std::size_t kFollowedVertices = 4096;
constexpr std::size_t kFollowedRays = 16;

// Returns the length of the longest edge at each vertex with wanted[v] != 0.
std::vector<float> longest_edges(const BakeGeometry& geometry, std::span<const std::uint8_t> wanted) {
    std::vector<float> around(geometry.positions.size(), 0);
    for (const glm::uvec3& t : geometry.triangles) {
        if (wanted[t.x] + wanted[t.y] + wanted[t.z] == 0) continue;
        for (glm::length_t k = 0; k < 3; ++k) {
            const std::uint32_t a = t[k];
            const std::uint32_t b = t[(k + 1) % 3];
            const auto edge = static_cast<float>(
                glm::distance(glm::dvec3(geometry.positions[a]), glm::dvec3(geometry.positions[b])));
            around[a] = std::max(around[a], edge);
            around[b] = std::max(around[b], edge);
        }
    }
    return around;
}

}  // namespace

std::vector<WantedLength> blocked_lengths(const BakeGeometry& geometry, const DirectionSet& directions,
                                          const Visibility& baked, const RayScene& scene,
                                          std::span<const std::uint32_t> occluded,
                                          std::span<const glm::vec3> shifts) {
    const std::size_t count = std::min(occluded.size(), kFollowedVertices);
    const auto followed = [&](std::size_t i) { return occluded[i * occluded.size() / count]; };
    std::vector<std::uint8_t> wanted(geometry.positions.size(), 0);
    for (std::size_t i = 0; i < count; ++i) wanted[followed(i)] = 1;
    const std::vector<float> around = longest_edges(geometry, wanted);
    std::vector<WantedLength> found(count * kFollowedRays,
                                    WantedLength{.triangle = 0, .weights{}, .length = 0});
    tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
        const std::uint32_t v = followed(i);
        const glm::dvec3 origin = glm::dvec3(geometry.positions[v]) + glm::dvec3(shifts[v]);
        std::vector<std::size_t> blocked;
        for (std::size_t b = 0; b < directions.bundles().size(); ++b) {
            const std::uint16_t seen = bundle_bits(baked.at(v).data(), b);
            if (seen == 0xFFFF) continue;
            unsigned rays = dispatch<rays_above>(directions.bundles()[b], geometry.normals[v], 0.0F) & ~seen;
            for (; rays != 0; rays &= rays - 1) {
                const std::size_t d = RayBundle::kRays * b + static_cast<std::size_t>(std::countr_zero(rays));
                if (d < directions.size()) blocked.push_back(d);
            }
        }
        const std::size_t rays = std::min(blocked.size(), kFollowedRays);
        for (std::size_t r = 0; r < rays; ++r) {
            const std::size_t d = blocked[r * blocked.size() / rays];
            const auto hit =
                scene.intersect({.origin = origin, .direction = glm::dvec3(directions.directions()[d])});
            if (!hit) continue;
            found[i * kFollowedRays + r] = {.triangle = hit->triangle,
                                            .weights = glm::vec3(1 - hit->b1 - hit->b2, hit->b1, hit->b2),
                                            .length = std::max(static_cast<float>(hit->distance), around[v])};
        }
    });
    std::erase_if(found, [](const WantedLength& wanted) { return wanted.length == 0; });
    return found;
}

}  // namespace nicol
