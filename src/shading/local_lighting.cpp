// SPDX-License-Identifier: MIT
#include "shading/local_lighting.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "material/sampled_terms.hpp"
#include "material/spatial_variation.hpp"
#include "shading/light_changes.hpp"
#include "shading/light_samples.hpp"
#include "shading/pixel_places.hpp"
#include "shading/reflected_light.hpp"
#include "shading/reflected_nodes.hpp"
#include "shading/sample_halves.hpp"
#include "shading/shadow_rays.hpp"

namespace nicol {
namespace {

LaneVectors in_lanes(std::span<const glm::vec3> from) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out, i, from[std::min(i, from.size() - 1)]);
    return out;
}

}  // namespace

LocalLighting::LocalLighting(Lights lights, const RayScene* rays, int samples)
    : lights_(std::move(lights)), rays_(rays), samples_(static_cast<std::uint32_t>(samples)) {}

bool LocalLighting::needs_pixels(const Material& material) const {
    const bool any = lights_.any_source();
    return any_term(material, [&](const Material& layer, int term) {
        return is_sampled(layer, term, sampled()) ||
               (any && !layer.smooth(term) && layer.lobe_width(term) < PixelPlaces::kWidestLobe);
    });
}

namespace {

// Up to sixteen points, and their sums of reflected light.
class LitBatch {
public:
    LitBatch(const Views& views, const LitPoints& points, const LitMaterial& material, const RayScene* rays,
             const LocalLighting::Lights& lights, std::span<std::array<Lanes, 4>> sums)
        : positions_(in_lanes(points.positions)),
          origins_(points.origins.empty() ? positions_ : in_lanes(points.origins)),
          facets_(points.facets.empty() ? LaneVectors() : in_lanes(points.facets)),
          points_(points),
          material_(material),
          sums_(sums),
          all_((1U << points.positions.size()) - 1) {
        reflected_.set(views, points.positions, points.normals, points.tangents);
        if (points.mirrored != nullptr) set_pixels(*points.mirrored);
        // The bake, which says what is shadowed, knows no glass.
        if (rays != nullptr && points.receives_shadows && (points.shadowed || lights.glass != nullptr))
            shadows_.emplace(*rays, lights.glass.get(), positions_, origins_);
        if (lights.before_mirrors != nullptr && any_layer_has(true))
            before_mirrors_.emplace(*lights.before_mirrors, nullptr, positions_, origins_);
    }

    // Prepares add_source().
    void find_places() {
        if (points_.mirrored != nullptr)
            places_ = PixelPlaces(*points_.mirrored, points_.positions.size(), points_.parts,
                                  reflected_.mirrored_directions());
    }

    // Adds the rough terms' reflection of one light, but for terms that find it.
    void add_source(const LightSource& source, SampledTerms find_it, std::uint32_t index,
                    std::uint32_t most_samples) {
        const float radius = source.angular_radius(points_.positions.front());
        const std::uint32_t samples = light_sample_count(radius, most_samples);
        const double lobe = narrowest_lobe(find_it);
        seed(index);
        constexpr std::uint32_t probes = 4;
        LightShadows shadowing(shadows(), points_.places, probes);
        // Adds the samples first <= k < last of `all`.
        const auto add = [&](std::uint32_t first, std::uint32_t last, std::uint32_t all) {
            for (std::uint32_t k = first; k < last; ++k) {
                Lanes u{}, v{};
                if (radius > 0) light_samples(k, std::span(seeds_).first(points_.positions.size()), u, v);
                source.sample(positions_, u, v, light_);
                const std::uint32_t lit = all == 1 ? shadowing.reached_in_part(light_, lit_points())
                                                   : shadowing.reached(light_, lit_points());
                if (lit == 0) continue;
                const float factor = 1 / static_cast<float>(all);
                for_places(lobe, k, all, [&](float share) {
                    for_layers(
                        lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
                            reflected_.add(layer, weights, light_, there, share * factor, sums_, find_it);
                        });
                });
            }
        };
        SampleHalves halves(sums_);
        std::uint32_t first = samples / 2, all = samples;
        add(0, first, samples);
        halves.end_first();
        add(first, samples, samples);
        // Points at the edge of a small light's shadow get as many samples as of a very wide light.
        if (samples > 1 && samples < 2 * most_samples && shadowing.at_edge()) {
            first = samples;
            all = 2 * most_samples;
            halves.end_first(static_cast<float>(first) / static_cast<float>(all));
            add(first, all, all);
        }
        if (all == 1) {
            noise_ += halves.squares(points_.positions.size(), shadowing.doubts());
            return;
        }
        Lanes weights, shares;
        weights.value.fill(static_cast<float>(first) / static_cast<float>(all));
        shares.value.fill(kShareOfHalves);
        noise_ += halves.noise(points_.positions.size(), weights, shares);
    }

    // Adds the smooth terms' reflection of one light.
    void add_mirrored(const LightSource& source) {
        source.intersect(origins_, reflected_.mirrored_directions(), light_);
        add_mirrored();
    }

    // Adds the sampled terms' reflection of the environment.
    void add_environment(const SampledEnvironment& environment) {
        for_layers(all_, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
            for (const Lobe& lobe : ReflectedLight::sampled_lobes(layer, environment.sampled()))
                add_lobe(environment, layer, lobe, weights, there);
        });
        if (environment.sampled() != SampledTerms::anisotropic_narrow || !any_layer_has(true)) return;
        look_up_mirrored(environment);
        add_mirrored();
    }

    // Returns whether a layer has smooth terms (or rough ones, if `smooth` is false).
    [[nodiscard]] bool any_layer_has(bool smooth) const {
        return std::ranges::any_of(material_.layers, [&](const Material* layer) {
            return any_term(*layer, [&](const Material& of, int term) { return of.smooth(term) == smooth; });
        });
    }
    [[nodiscard]] LightingTally tally() const {
        LightingTally out{
            .rays = (shadows_ ? shadows_->count() : 0) + (before_mirrors_ ? before_mirrors_->count() : 0),
            .values = sums_.size() * points_.positions.size(),
            .power = 0,
            .noise = noise_};
        for (const std::array<Lanes, 4>& stokes : sums_)
            for (const float s0 : stokes[0].value) out.power += double{s0} * double{s0};
        return out;
    }

private:
    // Returns an object that the thread keeps, so that frames allocate no memory.
    static LaneLight& kept_light() {
        thread_local LaneLight light;
        return light;
    }

    // Share of SampleHalves::noise() for nodes that are close enough; measured. Brushed lobes have rows of
    // nodes.
    static constexpr float kNodesError = 0.1F;
    static constexpr float kBrushedNodesError = 0.05F;

    static constexpr std::array<glm::vec2, 4> kQuarters{glm::vec2(0.25F), glm::vec2(0.75F),
                                                        glm::vec2(0.25F, 0.75F), glm::vec2(0.75F, 0.25F)};

    void add_lobe(const SampledEnvironment& environment, const Material& layer, const Lobe& lobe,
                  const LayerWeights* weights, std::uint32_t there) {
        const bool whole = finds_lights(lobe, environment.sampled());
        const LaneFrames frames = environment.in_environment(reflected_.frames());
        const WeightedTerms terms =
            ReflectedLight::sampled_terms(layer, environment.sampled(), lobe, sums_.size());
        // A shadow ray meets a single point of what a node's blob shows. The blobs of brushed lobes overlap,
        // so that their middles sample the lobe well.
        const bool scattered = lobe.alpha.x == lobe.alpha.y;
        const float error = scattered ? kNodesError : kBrushedNodesError;
        for (const SlopePart& part : slope_parts(lobe.distribution)) {
            const ReflectedNodes nodes(environment.grids(), lobe, part, reflected_.towards_viewer(), pixels_);
            const auto pairs = static_cast<std::uint32_t>((nodes.count() + 1) / 2);
            const std::uint32_t even = (pairs + 1) / 2;
            Lanes shares;
            for (std::size_t i = 0; i < kLanes; ++i) {
                const float square = nodes.excess()[i] * nodes.excess()[i];
                shares[i] = std::min(1.0F, error * square * square);
            }
            LightShadows shadowing(shadows(), points_.places, 2 * even);
            seed(~sampled_parts_++);
            // Sets light_ to the light of a node, and returns the points that it reaches.
            const auto light_of = [&](const ReflectedNode& node, std::uint32_t k) {
                environment.look_up(whole, frames, node, light_);
                return reached(shadowing, node, scattered ? std::optional(k) : std::nullopt, there);
            };
            const auto reflect = [&](std::uint32_t lit) {
                if (lit != 0) reflected_.add_sampled(terms, weights, light_, lit, sums_);
            };
            // Even pairs come first, because either half of the pairs is spread over the lobe.
            SampleHalves halves(sums_);
            for (std::uint32_t k = 0; k < pairs; ++k) {
                if (k == even) halves.end_first();
                const std::uint32_t own = k < even ? 2 * k : 2 * (k - even) + 1;
                if (environment.polarized()) {
                    for (std::uint32_t n = 0; n < 2; ++n)
                        reflect(light_of(nodes.node(2 * own + n), 2 * k + n));
                    continue;
                }
                const ReflectedPair pair = nodes.pair(own);
                thread_local std::vector<std::array<Lanes, 4>> first;
                const std::uint32_t first_lit = light_of(pair.nodes[0], 2 * k);
                hide(there & ~first_lit, light_);
                std::swap(first, light_.irradiance);
                const std::uint32_t lit = light_of(pair.nodes[1], 2 * k + 1);
                hide(there & ~lit, light_);
                add_unpolarized(first, light_);
                light_.towards = pair.towards;
                reflect(first_lit | lit);
            }
            if (even < pairs) noise_ += halves.noise(points_.positions.size(), nodes.even_shares(), shares);
        }
    }

    // Returns the points that reflect the light of a node. Light that surfaces hide becomes that which they
    // reflect, where it is known. scattered: number of the sample, if its shadow ray meets any point of what
    // the node's blob shows; none: the blob's middle.
    std::uint32_t reached(LightShadows& shadowing, const ReflectedNode& node,
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

    // Sets the light to the mean over the pixels around the mirrored directions.
    void look_up_mirrored(const SampledEnvironment& environment) {
        thread_local std::vector<std::array<Lanes, 4>> sums;
        const LaneFrames frames = environment.in_environment(reflected_.frames());
        const ReflectedNodes nodes(environment.grids(), reflected_.towards_viewer(), pixels_);
        sums.clear();
        for (std::size_t k = 0; k < nodes.count(); ++k) {
            environment.look_up(true, frames, nodes.node(k), light_);
            sums.resize(light_.irradiance.size(), {});
            for (std::size_t c = 0; c < sums.size(); ++c)
                for (std::size_t p = 0; p < light_.components; ++p)
                    for (std::size_t i = 0; i < kLanes; ++i) sums[c][p][i] += light_.irradiance[c][p][i];
        }
        std::ranges::copy(sums, light_.irradiance.begin());
        out_of_frames(reflected_.frames(), light_.towards, light_.towards);
        if (light_.components > 1) out_of_frames(reflected_.frames(), light_.x, light_.x);
    }

    // Calls reflect(share) for places of the pixels, with the light as these places reflect it. lobe: the
    // narrowest_lobe(). sample: number of the light sample, of `samples`.
    template <class Reflect>
    void for_places(double lobe, std::uint32_t sample, std::uint32_t samples, const Reflect& reflect) {
        const std::uint32_t across = places_.across(light_, lobe, samples);
        if (across == 0) return reflect(1.0F);
        const LaneVectors towards = light_.towards, x = light_.x;
        const auto count = static_cast<float>(across);
        // Four samples after one another shift the places to the middles of four quarters.
        const glm::vec2 shift = samples == 1 ? glm::vec2(0.5F) : kQuarters[sample % kQuarters.size()];
        for (std::uint32_t down = 0; down < across; ++down)
            for (std::uint32_t right = 0; right < across; ++right) {
                const glm::vec2 place(static_cast<float>(right), static_cast<float>(down));
                places_.move(towards, x, (place + shift) / count - 0.5F, light_);
                reflect(1 / (count * count));
            }
    }

    void add_mirrored() {
        std::uint32_t lit = lit_points();
        ShadowRays* const rays = before_mirrors_ ? &*before_mirrors_ : shadows();
        if (rays != nullptr && lit != 0) lit = rays->visible_from_origins(light_, lit);
        for_layers(lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
            reflected_.add_mirrored(layer, weights, light_, there, sums_);
        });
    }

    // Calls reflect(layer, weights, points) for those points that each layer covers.
    template <class Reflect>
    void for_layers(std::uint32_t points, const Reflect& reflect) {
        for (std::size_t l = 0; l < material_.layers.size(); ++l) {
            const LayerWeights* const weights = material_.weights.empty() ? nullptr : &material_.weights[l];
            const std::uint32_t there = weights != nullptr ? points & weights->points : points;
            if (there != 0) reflect(*material_.layers[l], weights, there);
        }
    }

    // Dims the light as perturbed normals need, and returns the points that it may reach.
    std::uint32_t lit_points() {
        dim();
        return facing_points();
    }
    void dim() {
        if (!points_.unperturbed.empty()) dim_at_slant(points_.unperturbed, points_.normals, light_);
    }
    [[nodiscard]] std::uint32_t facing_points() const {
        const std::uint32_t lit = all_ & light_.points & reflected_.lit(light_);
        return points_.facets.empty() ? lit : lit & above(facets_, light_);
    }

    // Returns the width of the narrowest rough lobe, but for terms that find the light.
    [[nodiscard]] double narrowest_lobe(SampledTerms find_it) const {
        double out = PixelPlaces::kWidestLobe;
        for (const Material* layer : material_.layers)
            for (int t = 0; t < layer->terms(); ++t)
                if (!layer->smooth(t) && !finds_lights(*layer, t, find_it))
                    out = std::min(out, layer->lobe_width(t));
        return out;
    }

    void set_pixels(const MirroredPixels& pixels) {
        into_frames(reflected_.frames(), pixels.shift, pixels_.shift);
        for (std::size_t k = 0; k < 2; ++k)
            into_frames(reflected_.frames(), pixels.steps[k], pixels_.steps[k]);
    }

    void seed(std::uint32_t index) {
        for (std::size_t i = 0; i < points_.positions.size(); ++i)
            seeds_[i] = sample_seed(points_.seeds[i], index);
    }

    [[nodiscard]] ShadowRays* shadows() { return shadows_ ? &*shadows_ : nullptr; }

    LaneVectors positions_, origins_, facets_;
    ReflectedLight reflected_;
    MirroredPixels pixels_;  // in the surfaces' frames
    PixelPlaces places_;
    std::optional<ShadowRays> shadows_, before_mirrors_;
    std::array<std::uint32_t, kLanes> seeds_{};
    std::uint32_t sampled_parts_ = 0;  // number of parts of lobes so far
    const LitPoints& points_;
    const LitMaterial& material_;
    LaneLight& light_ = kept_light();
    std::span<std::array<Lanes, 4>> sums_;
    double noise_ = 0;
    std::uint32_t all_;
};

}  // namespace

LightingTally LocalLighting::add(const Views& views, const LitPoints& points, const LitMaterial& material,
                                 const SampledEnvironment* environment, std::uint32_t samples,
                                 std::span<const std::span<glm::vec4>> out) const {
    const SampledTerms sampled = environment != nullptr ? environment->sampled() : SampledTerms::none;
    thread_local std::vector<std::array<Lanes, 4>> sums;
    sums.assign(out.size(), {});
    LitBatch batch(views, points, material, rays_, lights_, sums);
    if (lights_.any_source() && batch.any_layer_has(false)) {  // light samples have no effect otherwise
        batch.find_places();
        std::uint32_t index = 0;
        for (const LightSourcePtr& source : lights_.local)
            batch.add_source(*source, SampledTerms::none, index++, samples);
        for (const LightSourcePtr& source : lights_.extracted)
            batch.add_source(*source, sampled, index++, samples);
    }
    if (batch.any_layer_has(true)) {
        for (const LightSourcePtr& source : lights_.local) batch.add_mirrored(*source);
        if (sampled != SampledTerms::anisotropic_narrow)
            for (const LightSourcePtr& source : lights_.extracted) batch.add_mirrored(*source);
    }
    if (environment != nullptr) batch.add_environment(*environment);
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < points.positions.size(); ++i)
            out[c][i] += glm::vec4(sums[c][0][i], sums[c][1][i], sums[c][2][i], sums[c][3][i]);
    return batch.tally();
}

}  // namespace nicol
