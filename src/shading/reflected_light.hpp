// SPDX-License-Identifier: MIT
// Reflection of local lights by a pBRDF, without harmonics.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "light/lane_light.hpp"
#include "material/layer_weights.hpp"
#include "material/material.hpp"
#include "material/sampled_terms.hpp"
#include "polarization/views.hpp"
#include "shading/lane_frames.hpp"

namespace nicol {

/// Some of a material's terms.
struct WeightedTerms {
    const Material& material;
    std::span<const float> weights;  ///< [channel][term]; 0 for the other terms
};

/// Factor of a pBRDF times light: a polynomial in the cosine of the light to the surface.
struct ScaleByCosine {
    float by_cosine, by_square;
};

/// Sixteen points of a surface, seen from viewpoints. Holds results, so each thread needs its own object.
class ReflectedLight {
public:
    /// Sets at most kLanes positions and their unit shading normals, on the viewer's side for two-sided
    /// materials; the other lanes repeat the first. `tangents`: directions of growing texture coordinate u
    /// for anisotropic materials, unit or 0; empty: no material is anisotropic.
    void set(const Views& views, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const glm::vec3> tangents = {});

    /// Returns bits: bit i is set if light reaches point i (unless it is occluded) from above the horizon of
    /// its normal and the viewer is above that horizon too. add() adds nothing at other points, so they need
    /// no shadow ray.
    [[nodiscard]] std::uint32_t lit(const LaneLight& light) const;

    /// Adds to out[channel] the light that `material` reflects at the points of lit() whose bit is set in
    /// `points`, as Stokes vectors in the camera's frame field, without the smooth terms. The light is the
    /// pBRDF times irradiance, times the cosine, times `factor` (above 0), times the weights of a layer
    /// (null: 1). `material` must have no variation(). A light or a material of one channel serves all. The
    /// channels may be those of several lights, one light after the other, for which the material's channels
    /// repeat. Terms that find the light by themselves are left out: those of finds_lights(), or all that
    /// `find_it` names.
    void add(const Material& material, const LayerWeights* weights, const LaneLight& light,
             std::uint32_t points, float factor, std::span<std::array<Lanes, 4>> out,
             SampledTerms find_it = SampledTerms::none, bool all_sampled_find_it = false) const;

    /// Returns unit directions towards the viewer, in the surfaces' frames.
    [[nodiscard]] const LaneVectors& towards_viewer() const { return towards_viewer_; }
    /// Returns the surfaces' frames, in the positions' axes.
    [[nodiscard]] const LaneFrames& frames() const { return frames_; }

    /// Returns the different lobes of the rough terms that `sampled` names. They are valid until the thread's
    /// next call.
    [[nodiscard]] static std::span<const Lobe> sampled_lobes(const Material& material, SampledTerms sampled);
    /// Returns the terms with this lobe that `sampled` names. The weights are valid until the thread's next
    /// call of a function of this class but add_sampled().
    [[nodiscard]] static WeightedTerms sampled_terms(const Material& material, SampledTerms sampled,
                                                     const Lobe& lobe, std::size_t channels);
    /// Adds what add() adds by these terms. The directions of the light are in the surfaces' frames.
    void add_sampled(const WeightedTerms& terms, const LayerWeights* weights, const LaneLight& light,
                     std::uint32_t points, std::span<std::array<Lanes, 4>> out) const;

    /// Returns the unit directions, in the positions' axes, that the viewer sees in a mirror.
    [[nodiscard]] LaneVectors mirrored_directions() const;
    /// Adds the smooth terms alone, as mirrors. `light` comes from mirrored_directions() and has radiance in
    /// place of irradiance.
    void add_mirrored(const Material& material, const LayerWeights* weights, const LaneLight& light,
                      std::uint32_t points, std::span<std::array<Lanes, 4>> out) const;

private:
    // Returns the weights of the terms t with has(t).
    template <class Has>
    static std::span<const float> weights_of(const Material& material, std::size_t channels, const Has& has);
    // Directions of light in the surfaces' frames.
    struct Directions {
        LaneVectors towards;
        LaneVectors x;  // unset if the light is unpolarized
    };
    [[nodiscard]] Directions directions_of(const LaneLight& light) const;
    // scale: factor of the pBRDF times the light.
    void add_terms(const WeightedTerms& terms, const LayerWeights* weights, const LaneLight& light,
                   const Directions& directions, std::uint32_t points, const ScaleByCosine& scale,
                   std::span<std::array<Lanes, 4>> out) const;

    LaneFrames frames_;
    LaneVectors towards_viewer_;  // in the surface's frames
    // Cosine and sine of the rotation of (s1, s2) from the theta-phi frame to the camera's.
    Lanes frame_cosine_, frame_sine_;
};

}  // namespace nicol
