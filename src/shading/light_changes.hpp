// SPDX-License-Identifier: MIT
// Changes of the light that reaches sixteen points.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "light/lane_light.hpp"

namespace nicol {

/// Returns the bits of the points whose light comes from above their facets.
[[nodiscard]] std::uint32_t above(const LaneVectors& facets, const LaneLight& light);

/// Multiplies the irradiance of each point by its factor and by another one.
void scale(const Lanes& factors, LaneLight& light, float by = 1);

/// Removes the light of these points.
void hide(std::uint32_t points, LaneLight& light);

/// Gives light at least so many channels; those that are added are as the first.
void give_channels(std::size_t channels, LaneLight& light);

/// Adds s0 of another irradiance to unpolarized light. A single channel counts for all channels.
void add_unpolarized(std::span<const std::array<Lanes, 4>> irradiance, LaneLight& light);

/// Returns the sum of s0 over the channels.
[[nodiscard]] Lanes brightness(const LaneLight& light);

/// Returns the numbers of these points, and 0 for others.
[[nodiscard]] Lanes only(std::uint32_t points, const Lanes& numbers);

/// Dims light by the terminator_shadowing() of perturbed normals. The spans have equal lengths.
void dim_at_slant(std::span<const glm::vec3> unperturbed, std::span<const glm::vec3> normals,
                  LaneLight& light);

/// Moves the light's directions to places (u, v), 0 to 1, of blobs of these variances, in square radians
/// along each axis. A place below the horizon of a normal counts as the middle.
void scatter(std::span<const glm::vec3> normals, const Lanes& variances, const Lanes& u, const Lanes& v,
             LaneLight& light);

}  // namespace nicol
