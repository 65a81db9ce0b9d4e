// SPDX-License-Identifier: MIT
// Position and frames of the camera that receives the light of an image.
#pragma once

#include <glm/vec3.hpp>

#include "polarization/stokes.hpp"
#include "polarization/view_geometry.hpp"

namespace nicol {

struct Viewpoint {
    bool orthographic = false;
    glm::dvec3 eye{0.0};          ///< position in the world; a perspective camera's centre of projection
    glm::dvec3 forward{0, 0, 1};  ///< unit vector
    glm::dvec3 up{0, 1, 0};       ///< unit vector, orthogonal to forward
    glm::dvec3 right{-1, 0, 0};   ///< unit vector, to the image's right
    bool operator==(const Viewpoint&) const = default;

    [[nodiscard]] CameraAxes axes() const {
        return {.perspective = orthographic ? 0.0 : 1.0,
                .eye = {eye.x, eye.y, eye.z},
                .backward = {-forward.x, -forward.y, -forward.z},
                .up = {up.x, up.y, up.z},
                .right = {right.x, right.y, right.z}};
    }

    /// Returns towards_camera() of a point.
    [[nodiscard]] glm::dvec3 towards(const glm::dvec3& point) const {
        const Vector3<double> v = towards_camera(axes(), Vector3<double>{point.x, point.y, point.z});
        return {v.x, v.y, v.z};
    }

    /// Returns the camera's frame field (Eq. 83): z = propagation, x = camera_x(), which is the image's
    /// right.
    [[nodiscard]] Frame frame(const glm::dvec3& propagation) const {
        const CameraAxes camera = axes();
        const Vector3<double> x =
            camera_x(camera.up, camera.right, Vector3<double>{propagation.x, propagation.y, propagation.z});
        return frame_with_x(propagation, {x.x, x.y, x.z});
    }
};

}  // namespace nicol
