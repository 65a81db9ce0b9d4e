// SPDX-License-Identifier: MIT
// Reflection of samples of the environment by lobes, and of its mean by smooth terms.
#include <algorithm>
#include <optional>
#include <utility>

#include "shading/light_changes.hpp"
#include "shading/light_samples.hpp"
#include "shading/lit_batch.hpp"
#include "shading/sample_halves.hpp"

namespace nicol {
namespace {

// Share of SampleHalves::noise() for nodes that are close enough and all lit; measured. Brushed lobes have
// rows of nodes.
constexpr float kNodesError = 0.1F;
constexpr float kBrushedNodesError = 0.05F;
// Lobes so much longer than wide have so many nodes that the middles of their blobs sample the lobe well.
constexpr double kLongLobe = 3;

// Standard deviation of blobs that mirrors resolve, relative to the environment's narrowest ones; measured.
// Nodes closer to each other change a mirror's image by 0.2 % and double its cost.
constexpr float kResolved = 0.25F;

}  // namespace

void LitBatch::add_environment(const SampledEnvironment& environment) {
    for_layers(all_, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
        for (const Lobe& lobe : ReflectedLight::sampled_lobes(layer, environment.sampled()))
            add_lobe(environment, layer, lobe, weights, there);
    });
    if (environment.sampled().kind != SampledTerms::anisotropic_narrow || !any_layer_has(true)) return;
    look_up_mirrored(environment);
    add_mirrored();
}

void LitBatch::add_lobe(const SampledEnvironment& environment, const Material& layer, const Lobe& lobe,
                        const LayerWeights* weights, std::uint32_t there) {
    const bool whole = finds_lights(lobe, environment.sampled());
    const LaneFrames frames = environment.in_environment(reflected_.frames());
    const WeightedTerms terms =
        ReflectedLight::sampled_terms(layer, environment.sampled(), lobe, sums_.size());
    const double shorter = std::min(lobe.alpha.x, lobe.alpha.y);
    const double longer = std::max(lobe.alpha.x, lobe.alpha.y);
    // A shadow ray meets a single point of what a node's blob shows. With few nodes, the middles of blobs
    // would give shadows steps.
    const bool scattered = longer < kLongLobe * shorter;
    const float error = shorter == longer ? kNodesError : kBrushedNodesError;
    for (const SlopePart& part : slope_parts(lobe.distribution)) {
        const ReflectedNodes nodes(environment.grids(), lobe, part, reflected_.towards_viewer(), pixels_);
        const auto pairs = static_cast<std::uint32_t>((nodes.count() + 1) / 2);
        const std::uint32_t even = (pairs + 1) / 2;
        seen_lit_ = seen_hidden_ = 0;
        LightShadows shadowing(before_lobes(), points_.places, 2 * even);
        seed(~sampled_parts_++);
        // Returns the points that light_, the light of a node, reaches.
        const auto lit_by = [&](const ReflectedNode& node, std::uint32_t k) {
            return reached(shadowing, node, scattered ? std::optional(k) : std::nullopt, there);
        };
        const auto reflect = [&](std::uint32_t lit) {
            if (lit != 0) reflected_.add_sampled(terms, weights, light_, lit, sums_);
        };
        // Even pairs come first, because either half of the pairs is spread over the lobe.
        SampleHalves halves(sums_, points_.noise_factors);
        for (std::uint32_t k = 0; k < pairs; ++k) {
            if (k == even) halves.end_first();
            const std::uint32_t own = k < even ? 2 * k : 2 * (k - even) + 1;
            if (environment.polarized()) {
                for (std::uint32_t n = 0; n < 2; ++n) {
                    const ReflectedNode node = nodes.node(2 * own + n);
                    environment.look_up(whole, frames, node, light_);
                    reflect(lit_by(node, 2 * k + n));
                }
                continue;
            }
            const ReflectedPair pair = nodes.pair(own);
            thread_local std::vector<std::array<Lanes, 4>> first;
            PairLight light;
            // The light of neighbours leans alike.
            environment.look_up(whole, frames, pair.nodes[0], light_, light.lean);
            const std::uint32_t first_lit = lit_by(pair.nodes[0], 2 * k);
            hide(there & ~first_lit, light_);
            light.brightness[0] = brightness(light_);
            std::swap(first, light_.irradiance);
            environment.look_up(whole, frames, pair.nodes[1], light_);
            const std::uint32_t lit = lit_by(pair.nodes[1], 2 * k + 1);
            hide(there & ~lit, light_);
            light.brightness[1] = brightness(light_);
            add_unpolarized(first, light_);
            const PairDirection mean = nodes.direction_of(pair, light);
            light_.towards = mean.towards;
            scale(mean.factors, light_);
            reflect(first_lit | lit);
        }
        if (even == pairs) continue;
        Lanes shares;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const float square = nodes.excess()[i] * nodes.excess()[i];
            // A scattered ray finds the light or not, whatever its neighbours find.
            const bool some_hidden = scattered && (seen_lit_ & seen_hidden_ & std::uint32_t{1} << i) != 0;
            shares[i] = std::max(std::min(1.0F, error * square * square), some_hidden ? kShareOfHalves : 0);
        }
        noise_ += halves.noise(points_.positions.size(), nodes.even_shares(), shares);
    }
}

std::uint32_t LitBatch::reached(LightShadows& shadowing, const ReflectedNode& node,
                                std::optional<std::uint32_t> scattered, std::uint32_t there) {
    if (!shadows_ && points_.facets.empty() && points_.unperturbed.empty()) return there;
    const LaneVectors local = light_.towards;
    out_of_frames(reflected_.frames(), local, light_.towards);
    const std::uint32_t facing = there & facing_points();
    std::uint32_t lit = facing;
    if (shadows_ && facing != 0) {
        const LaneVectors middle = light_.towards;
        if (scattered) {
            Lanes u, v;
            light_samples(*scattered, std::span(seeds_).first(points_.normals.size()), u, v);
            scatter(points_.normals, node.variances, u, v, light_);
        }
        lit = shadowing.reached(light_, facing);
        light_.towards = middle;
        seen_lit_ |= lit;
        seen_hidden_ |= facing & ~lit;
    }
    if (points_.bounced != nullptr && lit != facing) {
        hide(facing & ~lit, light_);
        points_.bounced->add_to(only(facing & ~lit, node.weights), light_);
        lit = facing;
    }
    if (lit != 0) dim();
    light_.towards = local;
    return lit;
}

void LitBatch::look_up_mirrored(const SampledEnvironment& environment) {
    thread_local std::vector<std::array<Lanes, 4>> sums;
    thread_local LaneLight several;
    const LaneFrames frames = environment.in_environment(reflected_.frames());
    const float narrowest = kResolved * environment.narrowest();
    constexpr std::uint32_t all = (std::uint32_t{1} << kLanes) - 1;
    ReflectedNode one;
    const std::uint32_t narrow = mirror_node(narrowest, reflected_.towards_viewer(), pixels_, one);
    environment.look_up(true, frames, one, light_);
    if (narrow != all) {
        const ReflectedNodes nodes(environment.grids(), narrowest, reflected_.towards_viewer(), pixels_);
        sums.assign(light_.irradiance.size(), {});
        for (std::size_t k = 0; k < nodes.count(); ++k) {
            environment.look_up(true, frames, nodes.node(k), several);
            for (std::size_t c = 0; c < sums.size(); ++c)
                for (std::size_t p = 0; p < several.components; ++p)
                    for (std::size_t i = 0; i < kLanes; ++i) sums[c][p][i] += several.irradiance[c][p][i];
        }
        // A point's light must not depend on its neighbours in the lanes, which threads choose.
        for (std::size_t i = 0; i < kLanes; ++i) {
            if ((narrow >> i & 1) != 0) continue;
            for (std::size_t c = 0; c < sums.size(); ++c)
                for (std::size_t p = 0; p < light_.components; ++p)
                    light_.irradiance[c][p][i] = sums[c][p][i];
            put(light_.towards, i, vector_at(several.towards, i));
            if (light_.components > 1) put(light_.x, i, vector_at(several.x, i));
        }
    }
    out_of_frames(reflected_.frames(), light_.towards, light_.towards);
    if (light_.components > 1) out_of_frames(reflected_.frames(), light_.x, light_.x);
}

}  // namespace nicol
