// SPDX-License-Identifier: MIT
#include "reference/sky_disc.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "polarization/stokes.hpp"

namespace nicol {

using std::numbers::pi;

SkyDisc::SkyDisc(const SmallLight& light)
    : light_(&light),
      axes_(theta_phi_frame(-glm::normalize(glm::dvec3(light.to_world[2])))),
      sin_half_(std::sin(light.angular_radius / 2)) {
    const double sine = std::sin(light.angular_radius);
    per_irradiance_ = 1 / (pi * sine * sine);
}

glm::dvec3 SkyDisc::sample(const glm::dvec2& point) const {
    const double sin_half = sin_half_ * std::sqrt(point.x);
    const double sine = 2 * sin_half * std::sqrt(1 - sin_half * sin_half);
    const double phi = 2 * pi * point.y;
    return glm::normalize(
        axes_ * glm::dvec3(sine * std::cos(phi), sine * std::sin(phi), 1 - 2 * sin_half * sin_half));
}

double SkyDisc::pdf(const glm::dvec3& towards_light) const {
    // The chord of an angle is twice the sine of its half.
    if (glm::length(towards_light - axes_[2]) > 2 * sin_half_) return 0;
    return 1 / (4 * pi * sin_half_ * sin_half_);
}

double SkyDisc::radiance(int channel) const {
    return per_irradiance_ * textured_value(light_->value, nullptr, {}, channel);
}

}  // namespace nicol
