// SPDX-License-Identifier: MIT
// Light that reaches a point from lights without a size, and the axes of polarized light.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "light/local_light.hpp"

namespace nicol {

/// Returns whether all light of a local light reaches a point from one direction.
[[nodiscard]] bool without_size(const LocalLight& light) noexcept;

/// Returns the axis of a light's polarization, of length 1, in the coordinates to which `to_world` leads.
[[nodiscard]] glm::dvec3 axis_in_world(const glm::dmat4& to_world, const PolarizationState& state);

struct LightArrival {
    glm::dvec3 towards_light;  ///< unit vector in the world
    double distance;           ///< distance to the light; infinite for light from the sky
};

/// Returns the arrival of a light without a size at the point `position` of the world; none if no light
/// reaches the point. Sets `irradiance`, for each channel, to the irradiance of a surface at the point that
/// faces the light.
[[nodiscard]] std::optional<LightArrival> light_arrival(const LocalLight& light, const glm::dvec3& position,
                                                        std::span<double> irradiance);

}  // namespace nicol
