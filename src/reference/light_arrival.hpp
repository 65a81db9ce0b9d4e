// SPDX-License-Identifier: MIT
// What lights without a size send to a point.
#pragma once

#include <glm/vec3.hpp>
#include <optional>
#include <span>

#include "light/local_light.hpp"

namespace nicol {

/// Whether all its light reaches a point from one direction.
[[nodiscard]] bool without_size(const LocalLight& light) noexcept;

struct LightArrival {
    glm::dvec3 towards_light;  ///< unit, in the world
    double distance;           ///< to the light; infinite from the sky
};

/// For a light without a size. `irradiance`, of each channel, becomes that of a surface at the point
/// `position` of the world that faces the light. None where no light reaches it.
[[nodiscard]] std::optional<LightArrival> light_arrival(const LocalLight& light, const glm::dvec3& position,
                                                        std::span<double> irradiance);

}  // namespace nicol
