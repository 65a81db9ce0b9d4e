// SPDX-License-Identifier: MIT
#include "shading/local_lighting.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "material/spatial_variation.hpp"
#include "shading/light_samples.hpp"
#include "shading/normal_variation.hpp"
#include "shading/reflected_light.hpp"

namespace nicol {
namespace {

LaneVectors in_lanes(std::span<const glm::vec3> from) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out, i, from[std::min(i, from.size() - 1)]);
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

// Dims light by the terminator shadowing of perturbed normals.
void dim(const LitPoints& points, LaneLight& light) {
    Lanes factor{};
    for (std::size_t i = 0; i < points.unperturbed.size(); ++i) {
        const glm::vec3& normal = points.unperturbed[i];
        const glm::vec3 towards(light.towards.x[i], light.towards.y[i], light.towards.z[i]);
        factor[i] = terminator_shadowing(glm::dot(normal, points.normals[i]), glm::dot(normal, towards));
    }
    for (std::array<Lanes, 4>& of_channel : light.irradiance)
        for (std::size_t p = 0; p < light.components; ++p)
            for (std::size_t i = 0; i < kLanes; ++i) of_channel[p][i] *= factor[i];
}

// Shadow rays from points to light samples.
class ShadowRays {
public:
    ShadowRays(const RayScene& scene, const LaneVectors& points, const LaneVectors& origins) : scene_(scene) {
        for (std::size_t i = 0; i < kLanes; ++i)
            offset_[i] = std::hypot(origins.x[i] - points.x[i], origins.y[i] - points.y[i],
                                    origins.z[i] - points.z[i]);
        packet_.origin_x = origins.x.value;
        packet_.origin_y = origins.y.value;
        packet_.origin_z = origins.z.value;
    }

    // Returns the bits of `points` whose light sample is not occluded.
    std::uint32_t visible(const LaneLight& light, std::uint32_t points) {
        packet_.direction_x = light.towards.x.value;
        packet_.direction_y = light.towards.y.value;
        packet_.direction_z = light.towards.z.value;
        // Light distances begin at the points.
        for (std::size_t i = 0; i < kLanes; ++i) packet_.farthest[i] = light.distance[i] - offset_[i];
        count_ += static_cast<std::uint64_t>(std::popcount(points));
        return points & ~std::uint32_t{scene_.occluded(packet_, static_cast<std::uint16_t>(points))};
    }

    [[nodiscard]] std::uint64_t count() const { return count_; }

private:
    RayPacket packet_;
    Lanes offset_;  // distance between the points and the rays' origins
    const RayScene& scene_;
    std::uint64_t count_ = 0;
};

// Returns the number of light samples for a light of this angular radius: `most` from 0.2 radians on, fewer
// for smaller lights, because their soft shadows are narrower.
std::uint32_t places_of(float angular_radius, std::uint32_t most) {
    constexpr float wide = 0.2F;
    constexpr std::uint32_t fewest = 4;  // a number at which the first samples are stratified
    if (angular_radius <= 0) return 1;
    const float share = std::min(1.0F, angular_radius / wide) * static_cast<float>(most) / fewest;
    return std::min(most, fewest * static_cast<std::uint32_t>(std::ceil(share)));
}

// Shadows of one light with few rays: if the first few samples are visible from all points, or hidden from
// all points, the other samples are assumed to be so too.
class LightShadows {
public:
    explicit LightShadows(ShadowRays* rays) : rays_(rays) {}

    // Returns the bits of `points` that the k-th light sample reaches.
    std::uint32_t reached(std::uint32_t k, const LaneLight& light, std::uint32_t points) {
        if (rays_ == nullptr || points == 0) return points;
        constexpr std::uint32_t probes = 4;
        if (k >= probes && seen_ != hidden_) return seen_ ? points : 0;
        const std::uint32_t visible = rays_->visible(light, points);
        seen_ = seen_ || visible != 0;
        hidden_ = hidden_ || visible != points;
        return visible;
    }

private:
    ShadowRays* rays_;
    bool seen_ = false;    // whether any sample is visible from any point
    bool hidden_ = false;  // whether any sample is hidden from any point
};

}  // namespace

bool has_terms(const Material& material, bool smooth) {
    if (const SpatialVariation* const variation = material.variation())
        return std::ranges::any_of(variation->layers, [&](const MaterialLayer& layer) {
            return has_terms(*layer.material, smooth);
        });
    for (int t = 0; t < material.terms(); ++t)
        if (material.smooth(t) == smooth) return true;
    return false;
}

LocalLighting::LocalLighting(std::vector<LightSourcePtr> sources, const RayScene* rays, int samples)
    : sources_(std::move(sources)), rays_(rays), samples_(static_cast<std::uint32_t>(samples)) {}

std::uint64_t LocalLighting::add(const Viewpoint& view, const LitPoints& points, const LitMaterial& material,
                                 std::span<const std::span<glm::vec4>> out) const {
    const std::size_t count = points.positions.size();
    const std::uint32_t all = (1U << count) - 1;
    const LaneVectors positions = in_lanes(points.positions);
    const LaneVectors origins = points.origins.empty() ? positions : in_lanes(points.origins);
    const LaneVectors facets = points.facets.empty() ? LaneVectors() : in_lanes(points.facets);
    thread_local ReflectedLight reflected;
    thread_local LaneLight light;
    thread_local std::vector<std::array<Lanes, 4>> sums;
    reflected.set(view, points.positions, points.normals, points.tangents);
    sums.assign(out.size(), {});
    std::optional<ShadowRays> shadows;
    if (rays_ != nullptr && points.shadowed) shadows.emplace(*rays_, positions, origins);

    // Calls reflect(layer, weights, points) for those lit points that the layer covers.
    const auto for_layers = [&](std::uint32_t lit, const auto& reflect) {
        for (std::size_t l = 0; l < material.layers.size(); ++l) {
            const LayerWeights* const weights = material.weights.empty() ? nullptr : &material.weights[l];
            const std::uint32_t there = weights != nullptr ? lit & weights->points : lit;
            if (there != 0) reflect(*material.layers[l], weights, there);
        }
    };
    const auto any_layer_has = [&](bool smooth) {
        return std::ranges::any_of(material.layers,
                                   [&](const Material* layer) { return has_terms(*layer, smooth); });
    };
    const auto lit_points = [&] {
        const std::uint32_t lit = all & light.points & reflected.lit(light);
        return points.facets.empty() ? lit : lit & above(facets, light);
    };

    std::array<std::uint32_t, kLanes> seeds{};
    const bool all_smooth = !any_layer_has(false);  // light samples have no effect then
    for (std::size_t s = 0; !all_smooth && s < sources_.size(); ++s) {
        const LightSource& source = *sources_[s];
        const float radius = source.angular_radius(points.positions.front());
        const std::uint32_t samples = places_of(radius, samples_);
        const float factor = 1 / static_cast<float>(samples);
        for (std::size_t i = 0; i < count; ++i)
            seeds[i] = sample_seed(points.seeds[i], static_cast<std::uint32_t>(s));
        LightShadows shadowing(shadows ? &*shadows : nullptr);
        for (std::uint32_t k = 0; k < samples; ++k) {
            Lanes u{}, v{};
            if (radius > 0) light_samples(k, std::span(seeds).first(count), u, v);
            source.sample(positions, u, v, light);
            if (!points.unperturbed.empty()) dim(points, light);
            const std::uint32_t lit = shadowing.reached(k, light, lit_points());
            for_layers(lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
                reflected.add(layer, weights, light, there, factor, sums);
            });
        }
    }
    if (any_layer_has(true)) {
        const LaneVectors mirrored = reflected.mirrored_directions();
        for (const LightSourcePtr& source : sources_) {
            source->intersect(origins, mirrored, light);
            if (!points.unperturbed.empty()) dim(points, light);
            std::uint32_t lit = lit_points();
            if (shadows && lit != 0) lit = shadows->visible(light, lit);
            for_layers(lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
                reflected.add_mirrored(layer, weights, light, there, sums);
            });
        }
    }
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < count; ++i)
            out[c][i] += glm::vec4(sums[c][0][i], sums[c][1][i], sums[c][2][i], sums[c][3][i]);
    return shadows ? shadows->count() : 0;
}

}  // namespace nicol
