// SPDX-License-Identifier: MIT
// Directional lights with a size: discs of the sky.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "light/small_light.hpp"

namespace nicol {

/// Even radiance in the directions up to an angle from the middle. All directions are in the world.
class SkyDisc {
public:
    /// Of a directional light with an angular radius above 0, which it refers to.
    explicit SkyDisc(const SmallLight& light);

    [[nodiscard]] const SmallLight& light() const noexcept { return *light_; }
    /// A unit direction towards the light, evenly by solid angle; `point` in [0, 1)^2.
    [[nodiscard]] glm::dvec3 sample(const glm::dvec2& point) const;
    /// The density of a unit direction, per steradian: 0 outside.
    [[nodiscard]] double pdf(const glm::dvec3& towards_light) const;
    [[nodiscard]] double radiance(int channel) const;

private:
    const SmallLight* light_;
    glm::dmat3 axes_;        ///< z towards the middle
    double sin_half_;        ///< of half the radius: exact for the smallest
    double per_irradiance_;  ///< radiance of the irradiance 1
};

}  // namespace nicol
