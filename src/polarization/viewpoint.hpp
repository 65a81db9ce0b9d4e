// SPDX-License-Identifier: MIT
// Where the light of an image is received, and the frames it is measured in.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "polarization/stokes.hpp"

namespace nicol {

struct Viewpoint {
    bool orthographic = false;
    glm::dvec3 eye{0.0};          ///< world; a perspective camera's centre
    glm::dvec3 forward{0, 0, 1};  ///< unit
    glm::dvec3 up{0, 1, 0};       ///< unit, orthogonal to forward
    glm::dvec3 right{-1, 0, 0};   ///< unit, to the image's right
    bool operator==(const Viewpoint&) const = default;

    /// Unit vector from a point of the scene to the camera: the propagation of the light that makes its
    /// pixel. A point at the camera itself counts as one straight ahead.
    [[nodiscard]] glm::dvec3 towards(const glm::dvec3& point) const {
        return orthographic || point == eye ? -forward : glm::normalize(eye - point);
    }

    /// The camera's frame field (Eq. 83): z = propagation, x = ray x up, which is the image's right, as in
    /// Mitsuba 3. Straight above and below the camera, where that is undefined, x is the camera's own right.
    [[nodiscard]] Frame frame(const glm::dvec3& propagation) const {
        const glm::dvec3 x = glm::cross(up, propagation);
        const double length2 = glm::dot(x, x);
        return frame_with_x(propagation, length2 > 1e-12 ? x : right);
    }
};

}  // namespace nicol
