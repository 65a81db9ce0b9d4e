// SPDX-License-Identifier: MIT
#include "polarization/stokes.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {

Stokes rotated(const Stokes& s, double angle) {
    const double c = std::cos(2 * angle);
    const double n = std::sin(2 * angle);
    return {s[0], c * s[1] + n * s[2], c * s[2] - n * s[1], s[3]};
}

double angle_between(const Frame& from, const Frame& to) {
    return std::atan2(glm::dot(to[0], from[1]), glm::dot(to[0], from[0]));
}

Frame theta_phi_frame(const glm::dvec3& direction) {
    const double rho = std::hypot(direction.x, direction.y);
    const double cos_phi = rho > 0 ? direction.x / rho : 1;
    const double sin_phi = rho > 0 ? direction.y / rho : 0;
    return {{direction.z * cos_phi, direction.z * sin_phi, -rho}, {-sin_phi, cos_phi, 0}, direction};
}

Frame frame_with_x(const glm::dvec3& z, const glm::dvec3& x_hint) {
    const glm::dvec3 x = glm::normalize(x_hint - z * glm::dot(z, x_hint));
    return {x, glm::cross(z, x), z};
}

}  // namespace nicol
