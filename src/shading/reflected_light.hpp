// SPDX-License-Identifier: MIT
// What surfaces reflect of local lights, without harmonics.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "light/lane_light.hpp"
#include "material/layer_weights.hpp"
#include "material/material.hpp"
#include "polarization/viewpoint.hpp"

namespace nicol {

/// Sixteen points of a surface, seen from a viewpoint. Holds results; one object a thread.
class ReflectedLight {
public:
    /// At most kLanes positions and their unit shading normals, of two-sided materials on the viewer's side;
    /// the other lanes repeat the first. `tangents`: where texture coordinate u grows there, which
    /// anisotropic materials follow, unit or 0; empty: none is anisotropic.
    void set(const Viewpoint& view, std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const glm::vec3> tangents = {});

    /// Bit i: light reaches point i (unless something is in between) from above the horizon of its normal,
    /// and the viewer is above it as well. At all others add() adds nothing: they need no shadow ray.
    [[nodiscard]] std::uint32_t lit(const LaneLight& light) const;

    /// Adds to out[channel], Stokes vectors in the camera's frame field, what `material` reflects of `light`
    /// at those of lit() whose bit is set in `points`, but for its smooth terms: the sum over columns of its
    /// pBRDF times irradiance, times the cosine, times `factor` (above 0), times the weights of a layer
    /// (null: 1). `material` is one without variation(). A light or a material of one channel serves all.
    void add(const Material& material, const LayerWeights* weights, const LaneLight& light,
             std::uint32_t points, float factor, std::span<std::array<Lanes, 4>> out) const;

    /// Unit, in the positions' axes: what the viewer would see in a mirror.
    [[nodiscard]] LaneVectors mirrored_directions() const;
    /// The same as add() of the smooth terms alone, as mirrors: `light` comes from mirrored_directions(), and
    /// has radiance in place of irradiance.
    void add_mirrored(const Material& material, const LayerWeights* weights, const LaneLight& light,
                      std::uint32_t points, std::span<std::array<Lanes, 4>> out) const;

private:
    enum class Terms { rough, smooth };
    // scale(cosine): times what the pBRDF makes of the light.
    template <class Scale>
    void add_terms(Terms which, const Material& material, const LayerWeights* weights, const LaneLight& light,
                   std::uint32_t points, const Scale& scale, std::span<std::array<Lanes, 4>> out) const;

    // The axes of the surface's frames in the world.
    LaneVectors tangent_, bitangent_, normal_;
    LaneVectors towards_viewer_;  // in them
    // Cos and sin of the rotation of (s1, s2) from the theta-phi frame to the camera's.
    Lanes frame_cosine_, frame_sine_;
};

}  // namespace nicol
