// SPDX-License-Identifier: MIT
#include "visibility/vertex_rays.hpp"

#include <array>
#include <bit>

#include "simd/dispatch.hpp"

namespace nicol {
namespace {

// Smallest sine of elevation of a traced ray. Lower rays could meet the plane that they start from, which is
// accurate only to a few units in the last place of the distance. Hardly any direction lies there; it counts
// as visible.
constexpr float kGrazing = 0x1p-17F;

// Returns bits: bit i is set if the sine of elevation of direction i over the plane of the normal exceeds
// `least`.
[[gnu::always_inline]] inline std::uint16_t above(const RayBundle& bundle, const glm::vec3& normal,
                                                  float least) {
    std::array<std::uint16_t, RayBundle::kRays> bit{};
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) {
        const float sine = normal.x * bundle.x[i] + normal.y * bundle.y[i] + normal.z * bundle.z[i];
        bit[i] = sine > least ? static_cast<std::uint16_t>(1U << i) : std::uint16_t{0};
    }
    std::uint16_t all = 0;
    for (std::size_t i = 0; i < RayBundle::kRays; ++i) all = static_cast<std::uint16_t>(all | bit[i]);
    return all;
}

}  // namespace

std::uint64_t trace_vertex(const RayScene& scene, const DirectionSet& directions, const glm::vec3& origin,
                           const glm::vec3& normal, std::size_t vertex,
                           const std::optional<FormerBits>& former, Visibility& visibility) {
    const std::span<std::uint64_t> words = visibility.at(vertex);
    const std::size_t last = directions.bundles().size() - 1;
    const std::size_t rest = directions.size() - last * RayBundle::kRays;
    std::uint64_t rays = 0;
    bool unoccluded = true;
    for (std::size_t b = 0; b <= last; ++b) {
        const RayBundle& bundle = directions.bundles()[b];
        const unsigned real = b < last || rest == RayBundle::kRays ? 0xFFFFU : (1U << rest) - 1;
        const auto up = static_cast<std::uint16_t>(dispatch<above>(bundle, normal, 0.0F) & real);
        if (up == 0) continue;
        std::uint16_t blocked = 0;
        if (former && former->disturbed[b] == 0) {
            blocked = static_cast<std::uint16_t>(up & ~(former->bits[b / 4] >> (16 * (b % 4))));
        } else {
            const auto needed = static_cast<std::uint16_t>(dispatch<above>(bundle, normal, kGrazing) & real);
            if (needed != 0) blocked = scene.occluded(origin, bundle, needed);
            rays += static_cast<std::uint64_t>(std::popcount(needed));
        }
        unoccluded = unoccluded && blocked == 0;
        words[b / 4] |= static_cast<std::uint64_t>(up & ~blocked) << (16 * (b % 4));
    }
    visibility.set_unoccluded(vertex, unoccluded);
    return rays;
}

}  // namespace nicol
