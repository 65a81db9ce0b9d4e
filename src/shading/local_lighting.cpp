// SPDX-License-Identifier: MIT
#include "shading/local_lighting.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "material/sampled_terms.hpp"
#include "material/spatial_variation.hpp"
#include "shading/lit_batch.hpp"
#include "shading/pixel_places.hpp"
#include "shading/shadow_rays.hpp"
#include "simd/lane_transpose.hpp"

namespace nicol {
namespace {

// Returns s0 by point, the sum over channels.
Lanes s0_of(std::span<const std::span<glm::vec4>> channels) {
    Lanes out{};
    for (const std::span<glm::vec4> channel : channels)
        for (std::size_t i = 0; i < channel.size(); ++i) out[i] += channel[i].x;
    return out;
}

// Moves sources up to a brightness to the end, the brightest of them first. Returns the first of them.
std::span<LitBatch::Source>::iterator move_dim(std::span<LitBatch::Source> sources, float brightness) {
    const auto is_dim = [=](const LitBatch::Source& source) { return source.brightness <= brightness; };
    if (std::ranges::none_of(sources, is_dim)) return sources.end();
    std::ranges::sort(sources, [&](const LitBatch::Source& a, const LitBatch::Source& b) {
        if (is_dim(a) != is_dim(b)) return is_dim(b);
        return is_dim(a) && a.brightness != b.brightness ? a.brightness > b.brightness : a.index < b.index;
    });
    return std::ranges::find_if(sources, is_dim);
}

// Adds light sources. Dim ones come last, because only then is known what they add to. there: s0 by point
// without the sources.
void add_sources(std::span<LitBatch::Source> sources, float negligible, const Lanes& there,
                 std::uint32_t samples, LitBatch& batch) {
    auto dim = sources.end();
    if (negligible > 0 && batch.casts_rays()) {
        float most = *std::ranges::max_element(there.value);
        for (const LitBatch::Source& source : sources) most = std::max(most, source.brightness);
        dim = move_dim(sources, negligible * most);
    }
    for (auto source = sources.begin(); source != dim; ++source) batch.add_source(*source, samples);
    for (; dim != sources.end(); ++dim) batch.add_dim_source(*dim, samples, negligible, there);
}

}  // namespace

LocalLighting::LocalLighting(Lights lights, const RayScene* rays, int samples, double negligible)
    : lights_(std::move(lights)),
      rays_(rays),
      samples_(static_cast<std::uint32_t>(samples)),
      negligible_(static_cast<float>(negligible)) {}

LocalLighting LocalLighting::with_light(LightSourcePtr source, std::size_t index) const {
    Lights lights;
    lights.local.push_back(std::move(source));
    lights.before_mirrors = lights_.before_mirrors;
    lights.glass = lights.glass_of_environment = lights_.glass_of_environment;
    lights.first_index = static_cast<std::uint32_t>(index);
    return {std::move(lights), rays_, static_cast<int>(samples_), 0};
}

std::vector<const LightSource*> LocalLighting::sources() const {
    std::vector<const LightSource*> out;
    out.reserve(lights_.local.size() + lights_.extracted.size());
    for (const auto* const lights : {&lights_.local, &lights_.extracted})
        for (const LightSourcePtr& light : *lights) out.push_back(light.get());
    return out;
}

std::uint32_t LocalLighting::reached(LaneLight& light, std::uint32_t points, const LaneVectors& positions,
                                     const LaneVectors& origins, std::uint64_t& rays) const {
    if (rays_ == nullptr) return points;
    ShadowRays shadows(*rays_, lights_.glass.get(), positions, origins);
    points = shadows.visible(light, points);
    rays += shadows.count();
    return points;
}

bool LocalLighting::needs_pixels(const Material& material) const {
    const bool any = lights_.any_source();
    return any_term(material, [&](const Material& layer, int term) {
        return is_sampled(layer, term, sampled()) ||
               (any && !layer.smooth(term) && layer.lobe_width(term) < PixelPlaces::kWidestLobe);
    });
}

LightingTally LocalLighting::add(const Views& views, const LitPoints& points, const LitMaterial& material,
                                 const SampledEnvironment* environment, std::uint32_t samples,
                                 std::span<const std::span<glm::vec4>> out) const {
    const SampledTerms sampled = environment != nullptr ? environment->sampled() : SampledTerms::none;
    thread_local std::vector<std::array<Lanes, 4>> sums;
    sums.assign(out.size(), {});
    LitBatch batch(views, points, material, rays_, lights_, sums);
    // Light samples have no effect otherwise.
    if (samples > 0 && lights_.any_source() && batch.any_layer_has(false)) {
        batch.find_places();
        thread_local std::vector<LitBatch::Source> sources;
        sources.clear();
        sources.reserve(lights_.local.size() + lights_.extracted.size());
        const auto list = [&](const std::vector<LightSourcePtr>& lights, SampledTerms find_it) {
            for (const LightSourcePtr& light : lights)
                sources.push_back({light.get(), find_it,
                                   lights_.first_index + static_cast<std::uint32_t>(sources.size()),
                                   light->brightness(points.positions.front())});
        };
        list(lights_.local, SampledTerms::none);
        list(lights_.extracted, sampled);
        add_sources(sources, negligible_, s0_of(out), samples, batch);
    }
    if (lights_.focused) batch.add_focused(*lights_.focused, SampledTerms::none);
    if (lights_.focused_extracted) batch.add_focused(*lights_.focused_extracted, sampled);
    if (batch.any_layer_has(true)) {
        for (const LightSourcePtr& source : lights_.local) batch.add_mirrored(*source);
        if (sampled.kind != SampledTerms::anisotropic_narrow)
            for (const LightSourcePtr& source : lights_.extracted) batch.add_mirrored(*source);
    }
    if (environment != nullptr) batch.add_environment(*environment);
    for (std::size_t c = 0; c < out.size(); ++c)
        add_fours(sums[c].data(), points.positions.size(), out[c].data());
    return batch.tally();
}

}  // namespace nicol
