// SPDX-License-Identifier: MIT
// Reflection of local lights and of samples of the environment at up to sixteen points.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <optional>
#include <span>
#include <vector>

#include "light/lane_light.hpp"
#include "shading/local_lighting.hpp"
#include "shading/part_reflections.hpp"
#include "shading/pixel_places.hpp"
#include "shading/reflected_light.hpp"
#include "shading/reflected_nodes.hpp"
#include "shading/shadow_rays.hpp"

namespace nicol {

/// Up to sixteen points, and their sums of reflected light.
class LitBatch {
public:
    /// A light source as a batch of points receives it.
    struct Source {
        const LightSource* light;
        SampledTerms find_it;  ///< terms that find the light by themselves, see finds_lights()
        std::uint32_t index;   ///< number of its samples' sequence
        float brightness;      ///< LightSource::brightness() at the batch
    };

    /// Keeps references to points, material and sums, which must outlive the object. rays: surfaces that cast
    /// shadows, null for none.
    LitBatch(const Views& views, const LitPoints& points, const LitMaterial& material, const RayScene* rays,
             const LocalLighting::Lights& lights, std::span<std::array<Lanes, 4>> sums);

    /// Prepares add_source().
    void find_places();
    /// Adds the rough terms' reflection of one light, but for terms that find it. most_samples: number of
    /// samples of wide lights.
    void add_source(const Source& source, std::uint32_t most_samples);
    /// Does the same for a dim light, and casts no shadow rays from points where the light adds next to
    /// nothing to what is there: to the sums and to `there`, s0 by point. Of such lights, no more than
    /// `negligible` of what is there is added without shadows.
    void add_dim_source(const Source& source, std::uint32_t most_samples, float negligible,
                        const Lanes& there);
    /// Adds the smooth terms' reflection of one light.
    void add_mirrored(const LightSource& source);
    /// Adds the rough terms' reflection of light that smooth surfaces send, but for terms that find it.
    void add_focused(const FocusedLight& focused, SampledTerms find_it);
    /// Adds the sampled terms' reflection of the environment.
    void add_environment(const SampledEnvironment& environment);

    /// Returns whether a layer has smooth terms (or rough ones, if `smooth` is false).
    [[nodiscard]] bool any_layer_has(bool smooth) const;
    /// Returns whether shadow rays are cast.
    [[nodiscard]] bool casts_rays() const noexcept { return shadows_.has_value(); }
    [[nodiscard]] LightingTally tally() const;

private:
    using Sums = std::span<std::array<Lanes, 4>>;
    struct Sampling;

    // Returns an object that the thread keeps, so that frames allocate no memory.
    static LaneLight& kept_light() {
        thread_local LaneLight light;
        return light;
    }

    [[nodiscard]] Sampling sampling_of(const Source& source);
    // Adds the samples first <= k < last of `all` of a light. reached(points): those that light_ reaches.
    template <class Reached>
    void add_samples(const Sampling& sampling, std::uint32_t first, std::uint32_t last, std::uint32_t all,
                     const Reached& reached, Sums sums);
    void add_lobe(const SampledEnvironment& environment, const Material& layer, const Lobe& lobe,
                  const LayerWeights* weights, std::uint32_t there);
    // Returns the points that reflect the light of a node. Light that surfaces hide becomes that which they
    // reflect, where it is known. scattered: number of the sample, if its shadow ray meets any point of what
    // the node's blob shows; none: the blob's middle.
    std::uint32_t reached(LightShadows& shadowing, const ReflectedNode& node,
                          std::optional<std::uint32_t> scattered, std::uint32_t there);
    // Sets the light to the mean over the pixels around the mirrored directions.
    void look_up_mirrored(const SampledEnvironment& environment);
    // Calls reflect(share, part) for places of the pixels, across x across of them, with the light as these
    // places reflect it. part: the part of the pixels at the place. sample: number of the light sample, of
    // `samples`.
    template <class Reflect>
    void for_places(std::uint32_t across, std::uint32_t sample, std::uint32_t samples,
                    const Reflect& reflect);
    // Calls reflect(reflection, share) for places within parts, with the light dimmed for each.
    template <class Reflect>
    void for_parts(std::uint32_t across, std::uint32_t sample, std::uint32_t samples, const Reflect& reflect);
    void add_mirrored();
    // Calls reflect(layer, weights, points) for those points that each layer covers.
    template <class Reflect>
    void for_layers(std::uint32_t points, const Reflect& reflect) const;
    // Dims the light as perturbed normals need, and returns the points that it may reach.
    std::uint32_t lit_points();
    void dim();
    [[nodiscard]] std::uint32_t facing_points() const;
    // Returns the points of whose pixels the light may reach any part.
    [[nodiscard]] std::uint32_t facing_parts();
    // Returns the points above whose facets, if known, the light is.
    [[nodiscard]] std::uint32_t before_facets(std::uint32_t points) const;
    // Returns the width of the narrowest rough lobe, but for terms that find the light.
    [[nodiscard]] double narrowest_lobe(SampledTerms find_it) const;
    void set_pixels(const MirroredPixels& pixels);
    void seed(std::uint32_t index);
    [[nodiscard]] ShadowRays* shadows() { return shadows_ ? &*shadows_ : nullptr; }
    [[nodiscard]] ShadowRays* before_mirrors() { return before_mirrors_ ? &*before_mirrors_ : shadows(); }
    // Returns the shadow rays of sampled lobes.
    [[nodiscard]] ShadowRays* before_lobes() {
        if (points_.rays_pass_glass) return before_mirrors();
        return before_environment_ ? &*before_environment_ : shadows();
    }

    Lanes unshadowed_{};  // s0 of dim lights that were added without shadows
    LaneVectors positions_, origins_, facets_;
    MirroredPixels pixels_;  // in the surfaces' frames
    std::optional<ShadowRays> shadows_, before_environment_, before_mirrors_;
    ReflectedLight reflected_;
    PixelPlaces places_;
    std::optional<PartReflections> parts_;  // set if textures perturb normals within the pixels
    std::uint64_t rays_spared_ = 0;         // shadow rays of dim lights that were added without shadows
    const Views& views_;
    const LitPoints& points_;
    const LitMaterial& material_;
    LaneLight& light_ = kept_light();
    double noise_ = 0;
    Sums sums_;
    std::uint32_t sampled_parts_ = 0;  // number of parts of lobes so far
    // Points at which shadow rays of the current part of a lobe found light, and a surface.
    std::uint32_t seen_lit_ = 0, seen_hidden_ = 0;
    std::uint32_t all_;
    std::array<std::uint32_t, kLanes> seeds_{};
};

template <class Reflect>
void LitBatch::for_layers(std::uint32_t points, const Reflect& reflect) const {
    for (std::size_t l = 0; l < material_.layers.size(); ++l) {
        const LayerWeights* const weights = material_.weights.empty() ? nullptr : &material_.weights[l];
        const std::uint32_t there = weights != nullptr ? points & weights->points : points;
        if (there != 0) reflect(*material_.layers[l], weights, there);
    }
}

}  // namespace nicol
