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

// Returns the bits of a bundle's directions above the plane of a normal.
std::uint16_t above(const DirectionSet& directions, std::size_t bundle, const glm::vec3& normal) {
    return static_cast<std::uint16_t>(dispatch<rays_above>(directions.bundles()[bundle], normal, 0.0F) &
                                      real_rays(directions, bundle));
}

// Adds the bits of full bundles' directions above the plane of a normal. One call for all of them, because a
// call takes as long as the work on a bundle.
[[gnu::always_inline]] inline void add_above(std::span<const RayBundle> bundles, const glm::vec3& normal,
                                             std::span<std::uint64_t> words) {
    for (std::size_t b = 0; b < bundles.size(); ++b)
        words[b / 4] |= static_cast<std::uint64_t>(rays_above(bundles[b], normal, 0.0F)) << (16 * (b % 4));
}

// Returns the rays of a bundle whose result may differ from the former one, `seen`.
std::uint16_t may_change(const FormerBits& former, std::size_t bundle, std::uint16_t seen) {
    return static_cast<std::uint16_t>((former.disturbed->may_close[bundle] & seen) |
                                      (former.disturbed->may_open[bundle] & ~seen));
}

// Returns whether a ray is blocked in a bundle in which no ray may change.
bool any_known_blocked(const DirectionSet& directions, const glm::vec3& normal, const FormerBits& former) {
    for (std::size_t b = 0; b < directions.bundles().size(); ++b) {
        const std::uint16_t seen = bundle_bits(former.bits.data(), b);
        if (seen == 0xFFFF || may_change(former, b, seen) != 0) continue;
        if ((above(directions, b, normal) & ~seen) != 0) return true;
    }
    return false;
}

// Sets the bits of a vertex whose former bits are those of the same normal. Bundles without a disturbed ray,
// which are most of them, keep their bits without a look at their directions.
RayCounts trace_disturbed(const BakeRays& scene, const DirectionSet& directions, const glm::vec3& origin,
                          const glm::vec3& normal, std::size_t vertex, const FormerBits& former,
                          std::span<const FlatBlockers::Cone> faces, Visibility& visibility) {
    const std::span<std::uint64_t> words = visibility.at(vertex);
    RayCounts rays;
    bool unoccluded = true;
    GatheredRays gathered(scene, origin, words);
    for (std::size_t b = 0; b < directions.bundles().size(); ++b) {
        const std::uint16_t seen = bundle_bits(former.bits.data(), b);
        const std::uint16_t changing = may_change(former, b, seen);
        if (changing == 0) {
            add_bundle_bits(words, b, seen);
            continue;
        }
        const RayBundle& bundle = directions.bundles()[b];
        const std::uint16_t up = above(directions, b, normal);
        auto traced = static_cast<std::uint16_t>(up & changing);
        auto blocked = static_cast<std::uint16_t>(up & ~seen & ~traced);
        if (traced != 0)
            traced = static_cast<std::uint16_t>(traced & dispatch<rays_above>(bundle, normal, kGrazing));
        const std::uint16_t known = FlatBlockers::blocked(faces, bundle, traced);
        traced = static_cast<std::uint16_t>(traced & ~known);
        blocked = static_cast<std::uint16_t>(blocked | known);
        rays.traced += static_cast<std::uint64_t>(std::popcount(traced));
        rays.skipped += static_cast<std::uint64_t>(std::popcount(known));
        unoccluded = unoccluded && blocked == 0;
        add_bundle_bits(words, b, static_cast<unsigned>(up & ~blocked));
        gathered.add(bundle, b, traced);
    }
    gathered.trace();
    unoccluded = unoccluded && !gathered.any_blocked();
    if (unoccluded && !former.unoccluded) unoccluded = !any_known_blocked(directions, normal, former);
    visibility.set_unoccluded(vertex, unoccluded);
    return rays;
}

}  // namespace

std::uint64_t set_open(const DirectionSet& directions, const glm::vec3& normal, std::size_t vertex,
                       Visibility& visibility) {
    const std::span<std::uint64_t> words = visibility.at(vertex);
    const std::size_t last = directions.bundles().size() - 1;
    dispatch<add_above>(directions.bundles().first(last), normal, words);
    add_bundle_bits(words, last, above(directions, last, normal));
    std::uint64_t count = 0;
    for (const std::uint64_t word : words) count += static_cast<std::uint64_t>(std::popcount(word));
    visibility.set_unoccluded(vertex, true);
    return count;
}

RayCounts trace_vertex(const BakeRays& scene, const DirectionSet& directions, const glm::vec3& origin,
                       const glm::vec3& normal, std::size_t vertex, const std::optional<FormerBits>& former,
                       std::span<const FlatBlockers::Cone> faces, Visibility& visibility) {
    if (former) return trace_disturbed(scene, directions, origin, normal, vertex, *former, faces, visibility);
    const std::span<std::uint64_t> words = visibility.at(vertex);
    RayCounts rays;
    bool unoccluded = true;
    for (std::size_t b = 0; b < directions.bundles().size(); ++b) {
        const RayBundle& bundle = directions.bundles()[b];
        const std::uint16_t up = above(directions, b, normal);
        if (up == 0) continue;
        const auto high = static_cast<std::uint16_t>(up & dispatch<rays_above>(bundle, normal, kGrazing));
        std::uint16_t blocked = FlatBlockers::blocked(faces, bundle, high);
        const auto traced = static_cast<std::uint16_t>(high & ~blocked);
        rays.traced += static_cast<std::uint64_t>(std::popcount(traced));
        rays.skipped += static_cast<std::uint64_t>(std::popcount(blocked));
        if (traced != 0)
            blocked =
                static_cast<std::uint16_t>(blocked | scene.occluded(origin, bundle, numbers_of(b), traced));
        unoccluded = unoccluded && blocked == 0;
        add_bundle_bits(words, b, static_cast<unsigned>(up & ~blocked));
    }
    visibility.set_unoccluded(vertex, unoccluded);
    return rays;
}

}  // namespace nicol
