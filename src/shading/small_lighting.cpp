// SPDX-License-Identifier: MIT
#include "shading/small_lighting.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "shading/light_places.hpp"
#include "shading/reflected_light.hpp"

namespace nicol {
namespace {

LaneVectors in_lanes(std::span<const glm::vec3> from) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const glm::vec3& v = from[std::min(i, from.size() - 1)];
        out.x[i] = v.x;
        out.y[i] = v.y;
        out.z[i] = v.z;
    }
    return out;
}

std::uint32_t above(const LaneVectors& facets, const LaneLight& light) {
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
        const float rise = facets.x[i] * light.towards.x[i] + facets.y[i] * light.towards.y[i] +
                           facets.z[i] * light.towards.z[i];
        out |= (rise > 0 ? 1U : 0U) << i;
    }
    return out;
}

// Of points to a place of a light.
class ShadowRays {
public:
    ShadowRays(const RayScene& scene, std::span<const glm::vec3> origins) : scene_(scene) {
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::vec3& origin = origins[std::min(i, origins.size() - 1)];
            packet_.origin_x[i] = origin.x;
            packet_.origin_y[i] = origin.y;
            packet_.origin_z[i] = origin.z;
        }
    }

    // The bits of `points` that something hides the light from.
    std::uint32_t hidden(const LaneLight& light, std::uint32_t points) {
        packet_.direction_x = light.towards.x.value;
        packet_.direction_y = light.towards.y.value;
        packet_.direction_z = light.towards.z.value;
        packet_.farthest = light.distance.value;
        count_ += static_cast<std::uint64_t>(std::popcount(points));
        return scene_.occluded(packet_, static_cast<std::uint16_t>(points));
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }

private:
    const RayScene& scene_;
    RayPacket packet_;
    std::uint64_t count_ = 0;
};

}  // namespace

SmallLighting::SmallLighting(std::vector<LightSourcePtr> sources, const RayScene* rays, int samples)
    : sources_(std::move(sources)), rays_(rays), samples_(static_cast<std::uint32_t>(samples)) {}

std::uint64_t SmallLighting::add(const Viewpoint& view, const LitPoints& points, const LitMaterial& material,
                                 std::span<const std::span<glm::vec4>> out) const {
    const std::size_t count = points.positions.size();
    const std::uint32_t all = (1U << count) - 1;
    const LaneVectors positions = in_lanes(points.positions);
    const LaneVectors facets = points.facets.empty() ? LaneVectors() : in_lanes(points.facets);
    thread_local ReflectedLight reflected;
    thread_local LaneLight light;
    thread_local std::vector<std::array<Lanes, 4>> sums;
    reflected.set(view, points.positions, points.normals);
    sums.assign(out.size(), {});
    std::optional<ShadowRays> shadows;
    if (rays_ != nullptr && points.shadowed) shadows.emplace(*rays_, points.origins);

    std::array<std::uint32_t, kLanes> seeds{};
    for (std::size_t s = 0; s < sources_.size(); ++s) {
        const LightSource& source = *sources_[s];
        const std::uint32_t samples = source.has_size() ? samples_ : 1;
        const float factor = 1 / static_cast<float>(samples);
        for (std::size_t i = 0; i < count; ++i)
            seeds[i] = place_seed(points.seeds[i], static_cast<std::uint32_t>(s));
        for (std::uint32_t k = 0; k < samples; ++k) {
            Lanes u{}, v{};
            if (source.has_size()) light_places(k, std::span(seeds).first(count), u, v);
            source.sample(positions, u, v, light);
            std::uint32_t lit = all & light.points & reflected.lit(light);
            if (!points.facets.empty()) lit &= above(facets, light);
            if (lit != 0 && shadows) lit &= ~shadows->hidden(light, lit);
            if (lit == 0) continue;
            for (std::size_t l = 0; l < material.layers.size(); ++l) {
                const LayerWeights* const weights = material.weights.empty() ? nullptr : &material.weights[l];
                const std::uint32_t there = weights != nullptr ? lit & weights->points : lit;
                if (there == 0) continue;
                reflected.add(*material.layers[l], weights, light, there, factor, sums);
            }
        }
    }
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < count; ++i)
            out[c][i] += glm::vec4(sums[c][0][i], sums[c][1][i], sums[c][2][i], sums[c][3][i]);
    return shadows ? shadows->count() : 0;
}

}  // namespace nicol
