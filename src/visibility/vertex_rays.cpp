// SPDX-License-Identifier: MIT
#include "visibility/vertex_rays.hpp"

#include <array>
#include <bit>

#include "simd/dispatch.hpp"
#include "visibility/bundle_bits.hpp"

namespace nicol {
namespace {

// Smallest sine of elevation of a traced ray. Lower rays could meet the plane that they start from, which is
// accurate only to a few units in the last place of the distance. Hardly any direction lies there; it counts
// as visible.
constexpr float kGrazing = 0x1p-17F;

// Returns the bits of a bundle's directions, without those that fill up the last one.
unsigned real_rays(const DirectionSet& directions, std::size_t bundle) {
    const std::size_t rest = directions.size() - bundle * RayBundle::kRays;
    return rest >= RayBundle::kRays ? 0xFFFFU : (1U << rest) - 1;
}

// Returns the numbers of a bundle's directions.
BakeRays::Numbers numbers_of(std::size_t bundle) {
    BakeRays::Numbers out;
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = RayBundle::kRays * bundle + i;
    return out;
}

/// Rays from one point in directions of several bundles, traced sixteen at a time.
class GatheredRays {
public:
    /// visible: words of bits, of which those of blocked rays are cleared.
    GatheredRays(const BakeRays& scene, const glm::vec3& origin, std::span<std::uint64_t> visible)
        : scene_(scene), origin_(origin), visible_(visible) {}

    /// Adds the rays of bundle number b whose bit is set.
    void add(const RayBundle& bundle, std::size_t b, std::uint16_t rays) {
        for (; rays != 0; rays = static_cast<std::uint16_t>(rays & (rays - 1))) {
            const auto i = static_cast<std::size_t>(std::countr_zero(rays));
            gathered_.x[count_] = bundle.x[i];
            gathered_.y[count_] = bundle.y[i];
            gathered_.z[count_] = bundle.z[i];
            numbers_[count_] = RayBundle::kRays * b + i;
            if (++count_ == RayBundle::kRays) trace();
        }
    }
    /// Traces the rays that were added since the last call.
    void trace() {
        if (count_ == 0) return;
        const auto active = static_cast<std::uint16_t>((1U << count_) - 1);
        std::uint16_t blocked = scene_.occluded(origin_, gathered_, numbers_, active);
        any_blocked_ = any_blocked_ || blocked != 0;
        for (; blocked != 0; blocked = static_cast<std::uint16_t>(blocked & (blocked - 1))) {
            const std::size_t ray = numbers_[static_cast<std::size_t>(std::countr_zero(blocked))];
            visible_[ray / 64] &= ~(std::uint64_t{1} << (ray % 64));
        }
        count_ = 0;
    }
    [[nodiscard]] bool any_blocked() const noexcept { return any_blocked_; }

private:
    RayBundle gathered_{};
    const BakeRays& scene_;
    const glm::vec3& origin_;
    std::span<std::uint64_t> visible_;
    BakeRays::Numbers numbers_{};
    std::size_t count_ = 0;
    bool any_blocked_ = false;
};

}  // namespace

std::uint64_t set_open(const DirectionSet& directions, const glm::vec3& normal, std::size_t vertex,
                       Visibility& visibility) {
    const std::span<std::uint64_t> words = visibility.at(vertex);
    std::uint64_t count = 0;
    for (std::size_t b = 0; b < directions.bundles().size(); ++b) {
        const unsigned up =
            dispatch<rays_above>(directions.bundles()[b], normal, 0.0F) & real_rays(directions, b);
        add_bundle_bits(words, b, up);
        count += static_cast<std::uint64_t>(std::popcount(up));
    }
    visibility.set_unoccluded(vertex, true);
    return count;
}

RayCounts trace_vertex(const BakeRays& scene, const DirectionSet& directions, const glm::vec3& origin,
                       const glm::vec3& normal, std::size_t vertex, const std::optional<FormerBits>& former,
                       std::span<const FlatBlockers::Cone> faces, Visibility& visibility) {
    const std::span<std::uint64_t> words = visibility.at(vertex);
    RayCounts rays;
    bool unoccluded = true;
    GatheredRays gathered(scene, origin, words);
    for (std::size_t b = 0; b < directions.bundles().size(); ++b) {
        const RayBundle& bundle = directions.bundles()[b];
        const auto up =
            static_cast<std::uint16_t>(dispatch<rays_above>(bundle, normal, 0.0F) & real_rays(directions, b));
        if (up == 0) continue;
        std::uint16_t blocked = 0;
        std::uint16_t traced = up;
        if (former) {
            const std::uint16_t seen = bundle_bits(former->bits.data(), b);
            const DisturbedBundles& disturbed = *former->disturbed;
            traced = static_cast<std::uint16_t>(
                up & ((disturbed.may_close[b] & seen) | (disturbed.may_open[b] & ~seen)));
            blocked = static_cast<std::uint16_t>(up & ~seen & ~traced);
        }
        if (traced != 0)
            traced = static_cast<std::uint16_t>(traced & dispatch<rays_above>(bundle, normal, kGrazing));
        const std::uint16_t known = FlatBlockers::blocked(faces, bundle, traced);
        traced = static_cast<std::uint16_t>(traced & ~known);
        blocked = static_cast<std::uint16_t>(blocked | known);
        rays.traced += static_cast<std::uint64_t>(std::popcount(traced));
        rays.skipped += static_cast<std::uint64_t>(std::popcount(known));
        if (!former && traced != 0)
            blocked =
                static_cast<std::uint16_t>(blocked | scene.occluded(origin, bundle, numbers_of(b), traced));
        unoccluded = unoccluded && blocked == 0;
        add_bundle_bits(words, b, static_cast<unsigned>(up & ~blocked));
        if (former) gathered.add(bundle, b, traced);
    }
    gathered.trace();
    visibility.set_unoccluded(vertex, unoccluded && !gathered.any_blocked());
    return rays;
}

}  // namespace nicol
