// SPDX-License-Identifier: MIT
#include "shading/lit_batch.hpp"

#include <algorithm>
#include <bit>
#include <glm/geometric.hpp>
#include <utility>

#include "shading/light_changes.hpp"
#include "shading/light_samples.hpp"
#include "shading/sample_halves.hpp"

namespace nicol {
namespace {

constexpr std::array<glm::vec2, 4> kQuarters{glm::vec2(0.25F), glm::vec2(0.75F), glm::vec2(0.25F, 0.75F),
                                             glm::vec2(0.75F, 0.25F)};

std::uint64_t count_of(const std::optional<ShadowRays>& rays) {
    return rays ? rays->count() : 0;
}

LaneVectors in_lanes(std::span<const glm::vec3> from) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out, i, from[std::min(i, from.size() - 1)]);
    return out;
}

}  // namespace

LitBatch::LitBatch(const Views& views, const LitPoints& points, const LitMaterial& material,
                   const RayScene* rays, const LocalLighting::Lights& lights, Sums sums)
    : positions_(in_lanes(points.positions)),
      origins_(points.origins.empty() ? positions_ : in_lanes(points.origins)),
      facets_(points.facets.empty() ? LaneVectors() : in_lanes(points.facets)),
      views_(views),
      points_(points),
      material_(material),
      sums_(sums),
      all_((1U << points.positions.size()) - 1) {
    reflected_.set(views, points.positions, points.normals, points.tangents);
    if (points.mirrored != nullptr) set_pixels(*points.mirrored);
    // The bake says what is shadowed, but clear glass stops none of its rays.
    if (rays != nullptr && points.receives_shadows && (points.shadowed || lights.glass != nullptr))
        shadows_.emplace(*rays, lights.glass.get(), positions_, origins_);
    if (shadows_ && lights.environment && lights.glass_of_environment != lights.glass)
        before_environment_.emplace(*rays, lights.glass_of_environment.get(), positions_, origins_);
    if (lights.before_mirrors != nullptr && (any_layer_has(true) || points.rays_pass_glass))
        before_mirrors_.emplace(*lights.before_mirrors, nullptr, positions_, origins_);
}

// The samples of one light.
struct LitBatch::Sampling {
    SampledTerms find_it;
    const LightSource& light;
    float radius;  // angular radius of the light
    double lobe;   // narrowest_lobe()
};

LitBatch::Sampling LitBatch::sampling_of(const Source& source) {
    seed(source.index);
    return {.find_it = source.find_it,
            .light = *source.light,
            .radius = source.light->angular_radius(points_.positions.front()),
            .lobe = narrowest_lobe(source.find_it)};
}

template <class Reached>
void LitBatch::add_samples(const Sampling& sampling, std::uint32_t first, std::uint32_t last,
                           std::uint32_t all, const Reached& reached, Sums sums) {
    for (std::uint32_t k = first; k < last; ++k) {
        Lanes u{}, v{};
        if (sampling.radius > 0) light_samples(k, std::span(seeds_).first(points_.positions.size()), u, v);
        sampling.light.sample(positions_, u, v, light_);
        const std::uint32_t across = places_.across(light_, sampling.lobe, all);
        const bool in_parts = across != 0 && parts_;
        const std::uint32_t lit = reached(in_parts ? facing_parts() : lit_points());
        if (lit == 0) continue;
        const float factor = 1 / static_cast<float>(all);
        const auto reflect = [&](const ReflectedLight& at, float share) {
            for_layers(lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
                at.add(layer, weights, light_, there, share * factor, sums, sampling.find_it);
            });
        };
        if (across == 0)
            reflect(reflected_, 1.0F);
        else if (!in_parts)
            for_places(across, k, all, [&](float share, std::size_t) { reflect(reflected_, share); });
        else
            for_parts(across, k, all, reflect);
    }
}

void LitBatch::add_source(const Source& source, std::uint32_t most_samples) {
    const Sampling sampling = sampling_of(source);
    const std::uint32_t samples = light_sample_count(sampling.radius, most_samples);
    constexpr std::uint32_t probes = 4;
    LightShadows shadowing(shadows(), points_.places, probes);
    const auto add = [&](std::uint32_t first, std::uint32_t last, std::uint32_t all) {
        const auto reached = [&](std::uint32_t points) {
            return all == 1 ? shadowing.reached_in_part(light_, points) : shadowing.reached(light_, points);
        };
        add_samples(sampling, first, last, all, reached, sums_);
    };
    SampleHalves halves(sums_, points_.noise_factors);
    if (samples == 1) {
        add(0, 1, 1);
        if (shadowing.doubtful()) noise_ += halves.squares(points_.positions.size(), shadowing.doubts());
        return;
    }
    std::uint32_t first = samples / 2, all = samples;
    add(0, first, samples);
    halves.end_first();
    add(first, samples, samples);
    // Points at the edge of a small light's shadow get as many samples as of a very wide light.
    if (samples < 2 * most_samples && shadowing.at_edge()) {
        first = samples;
        all = 2 * most_samples;
        halves.end_first(static_cast<float>(first) / static_cast<float>(all));
        add(first, all, all);
    }
    Lanes weights, shares;
    weights.value.fill(static_cast<float>(first) / static_cast<float>(all));
    shares.value.fill(kShareOfHalves);
    noise_ += halves.noise(points_.positions.size(), weights, shares);
}

void LitBatch::add_dim_source(const Source& source, std::uint32_t most_samples, float negligible,
                              const Lanes& there) {
    thread_local std::vector<std::array<Lanes, 4>> open;
    open.assign(sums_.size(), {});
    const Sampling sampling = sampling_of(source);
    const std::uint32_t samples = light_sample_count(sampling.radius, most_samples);
    std::uint32_t reached = 0;
    const auto all_of = [&](std::uint32_t points) {
        reached |= points;
        return points;
    };
    add_samples(sampling, 0, samples, samples, all_of, open);
    std::uint32_t rest = 0;
    Lanes kept{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        float added = unshadowed_[i], present = there[i];
        for (std::size_t c = 0; c < open.size(); ++c) {
            added += open[c][0][i];
            present += sums_[c][0][i];
        }
        if (added <= negligible * present) {
            unshadowed_[i] = added;
            kept[i] = 1;
        } else {
            rest |= reached & 1U << i;
        }
    }
    for (std::size_t c = 0; c < open.size(); ++c)
        for (std::size_t p = 0; p < 4; ++p)
            for (std::size_t i = 0; i < kLanes; ++i) sums_[c][p][i] += kept[i] * open[c][p][i];
    rays_spared_ += samples * static_cast<std::uint64_t>(std::popcount(reached & ~rest));
    if (rest == 0) return;
    const std::uint32_t whole = std::exchange(all_, rest);
    add_source(source, most_samples);
    all_ = whole;
}

void LitBatch::find_places() {
    if (points_.mirrored != nullptr)
        places_ = PixelPlaces(*points_.mirrored, points_.positions.size(), points_.parts,
                              reflected_.mirrored_directions());
    if (!points_.parts.empty()) parts_.emplace(views_, points_.positions, points_.tangents, points_.parts);
}

void LitBatch::add_mirrored(const LightSource& source) {
    source.intersect(origins_, reflected_.mirrored_directions(), light_);
    add_mirrored();
}

void LitBatch::add_focused(const FocusedLight& focused, SampledTerms find_it) {
    if (!points_.receives_shadows) return;  // nothing blocks their direct light
    focused.gather(points_.positions, points_.normals, light_);
    const std::uint32_t lit = lit_points();
    if (lit == 0) return;
    for_layers(lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
        // Rays that pass glass show sampled lobes the whole environment, its lights included.
        reflected_.add(layer, weights, light_, there, 1.0F, sums_, find_it, points_.rays_pass_glass);
    });
}

bool LitBatch::any_layer_has(bool smooth) const {
    return std::ranges::any_of(material_.layers, [&](const Material* layer) {
        return any_term(*layer, [&](const Material& of, int term) { return of.smooth(term) == smooth; });
    });
}

LightingTally LitBatch::tally() const {
    LightingTally out{.rays = count_of(shadows_) + count_of(before_environment_) + count_of(before_mirrors_),
                      .rays_spared = rays_spared_,
                      .values = 0,
                      .power = 0,
                      .noise = noise_};
    for (std::size_t i = 0; i < points_.positions.size(); ++i) {
        const double factor = points_.noise_factors.empty() ? 1.0F : points_.noise_factors[i];
        out.values += factor * static_cast<double>(sums_.size());
        for (const std::array<Lanes, 4>& stokes : sums_)
            out.power += factor * double{stokes[0][i]} * double{stokes[0][i]};
    }
    return out;
}

template <class Reflect>
void LitBatch::for_places(std::uint32_t across, std::uint32_t sample, std::uint32_t samples,
                          const Reflect& reflect) {
    const LaneVectors towards = light_.towards, x = light_.x;
    const auto count = static_cast<float>(across);
    // Four samples after one another shift the places to the middles of four quarters.
    const glm::vec2 shift = samples == 1 ? glm::vec2(0.5F) : kQuarters[sample % kQuarters.size()];
    for (std::uint32_t down = 0; down < across; ++down)
        for (std::uint32_t right = 0; right < across; ++right) {
            const glm::vec2 corner(static_cast<float>(right), static_cast<float>(down));
            const glm::vec2 place = (corner + shift) / count - 0.5F;
            places_.move(towards, x, place, light_);
            reflect(1 / (count * count), MirroredParts::at(place));
        }
}

template <class Reflect>
void LitBatch::for_parts(std::uint32_t across, std::uint32_t sample, std::uint32_t samples,
                         const Reflect& reflect) {
    thread_local std::vector<std::array<Lanes, 4>> whole;
    const bool dims = !points_.unperturbed.empty();
    if (dims) whole = light_.irradiance;
    for_places(across, sample, samples, [&](float share, std::size_t part) {
        const ReflectedLight& at = parts_->at(part);
        if (dims) {
            light_.irradiance = whole;
            dim_at_slant(points_.unperturbed, parts_->normals(part), light_);
        }
        reflect(at, share);
    });
}

void LitBatch::add_mirrored() {
    std::uint32_t lit = lit_points();
    ShadowRays* const rays = before_mirrors();
    if (rays != nullptr && lit != 0) lit = rays->visible_from_origins(light_, lit);
    for_layers(lit, [&](const Material& layer, const LayerWeights* weights, std::uint32_t there) {
        reflected_.add_mirrored(layer, weights, light_, there, sums_);
    });
}

std::uint32_t LitBatch::lit_points() {
    dim();
    return facing_points();
}

void LitBatch::dim() {
    if (!points_.unperturbed.empty()) dim_at_slant(points_.unperturbed, points_.normals, light_);
}

std::uint32_t LitBatch::facing_points() const {
    return before_facets(all_ & light_.points & reflected_.lit(light_));
}

std::uint32_t LitBatch::facing_parts() {
    std::uint32_t lit = 0;
    for (std::size_t part = 0; part < MirroredParts::kCount; ++part) lit |= parts_->at(part).lit(light_);
    return before_facets(all_ & lit);
}

std::uint32_t LitBatch::before_facets(std::uint32_t points) const {
    return points_.facets.empty() ? points : points & above(facets_, light_);
}

double LitBatch::narrowest_lobe(SampledTerms find_it) const {
    double out = PixelPlaces::kWidestLobe;
    for (const Material* layer : material_.layers)
        for (int t = 0; t < layer->terms(); ++t)
            if (!layer->smooth(t) && !finds_lights(*layer, t, find_it))
                out = std::min(out, layer->lobe_width(t));
    return out;
}

void LitBatch::set_pixels(const MirroredPixels& pixels) {
    into_frames(reflected_.frames(), pixels.shift, pixels_.shift);
    for (std::size_t k = 0; k < 2; ++k) into_frames(reflected_.frames(), pixels.steps[k], pixels_.steps[k]);
}

void LitBatch::seed(std::uint32_t index) {
    for (std::size_t i = 0; i < points_.positions.size(); ++i)
        seeds_[i] = sample_seed(points_.seeds[i], index);
}

}  // namespace nicol
