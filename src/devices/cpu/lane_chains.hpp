// SPDX-License-Identifier: MIT
// Chains of sixteen samples side by side, which meet one smooth boundary.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "devices/cpu/lane_boundary.hpp"
#include "geometry/ray_scene.hpp"
#include "light/lane_light.hpp"
#include "scene/projection.hpp"

namespace nicol {

/// Rays of chains, and the matrices from their light to the camera's frames.
struct LaneChains {
    BoundaryHits rays;  ///< the rays; the other members are set once it is known what they meet
    LaneVectors origins;
    Lanes carried;  ///< fractions of the samples' light
    /// Mueller matrices without the factors of materials: [4 row + column].
    std::array<Lanes, 16> matrices;
    std::vector<Lanes> factors;             ///< factors of materials, by channel
    std::array<std::uint32_t, kLanes> met;  ///< triangles that the rays meet
    std::array<std::uint32_t, kLanes> seeds;
    std::array<const SmoothBoundary*, kLanes> bodies;  ///< that the rays travel through; null: none
    std::uint32_t active = 0;                          ///< bit i: chain i goes on
    std::uint32_t open = 0;                            ///< bit i: ray i meets nothing
    int events = 0;                                    ///< number of events so far
};

/// Samples of an image, whose triangles are known.
struct ChainSamples {
    const Projection& projection;
    int width, height;                ///< of the image, in pixels
    std::array<double, kLanes> x, y;  ///< positions in the image, in pixels
    const LaneTriangles& triangles;
    double weight;  ///< of a sample in its pixel
};
/// Sets rays, origins and matrices of chains to those of samples, and the rays to where they meet the
/// triangles. Returns the bits of rays that run along their triangles, whose hits are undefined.
[[nodiscard]] std::uint32_t begin_chains(const ChainSamples& samples, LaneChains& out);

/// Choices of chains at a boundary.
struct LaneChoice {
    Lanes reflects;       ///< 1: the chain goes on with the reflected part; 0: the transmitted one
    Lanes probabilities;  ///< of the choice
    double reflectance, transmittance;  ///< mean factors of the material
};
/// Continues seeds, and factors of materials by those of a boundary's parts. onward: number from which seeds
/// follow where light is transmitted, and the next one where it is reflected. `out` may not be `from`.
void continue_factors(const LaneChains& from, const SmoothBoundary& boundary, const LaneChoice& choice,
                      std::uint32_t onward, LaneChains& out);
/// Continues rays, matrices and carried light beyond a boundary. `out` may not be `from`. Also returns, as
/// bits, which rays leave the front of their triangle.
[[nodiscard]] std::uint32_t continue_chains(const LaneChains& from, const LaneSplit& split,
                                            const LaneChoice& choice, LaneChains& out);

/// Directions of rays in the light's axes, and what a pyramid of the light needs.
struct LaneSky {
    LaneVectors directions;
    LaneVectors x;    ///< x axes of the frames that receive the light
    Lanes variances;  ///< of the directions within the samples
};
void find_sky(const LaneChains& chains, const glm::mat3& to_light, LaneSky& out);
/// Adds to sums[channel] the first `components` Stokes components, in the camera's frames, of light that some
/// of the chains find in the sky. scale: factor of the light.
void add_light(const LaneChains& chains, std::uint32_t some, const LaneSky& sky, const LaneLight& light,
               float scale, std::size_t components, std::span<std::array<Lanes, 4>> sums);

/// Returns the rays as a packet.
[[nodiscard]] RayPacket packet_of(const LaneChains& chains);

}  // namespace nicol
