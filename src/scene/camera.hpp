// SPDX-License-Identifier: MIT
// Parameters of cameras, defined as in Mitsuba 3.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nicol {

/// Camera. Camera space has +z forward, +y up, +x to the image's LEFT.
struct Camera {
    bool orthographic = false;
    /// Affine transform from camera space to the world. A perspective camera must not be scaled. For an
    /// orthographic camera, the lengths of the x and y axes are half the width of the image; its height
    /// follows from the aspect ratio and is scaled by y.
    glm::dmat4 to_world{1.0};
    double fov = 45;  ///< horizontal field of view of a perspective camera, in degrees, in (0, 180)
    double near_clip = 1e-2;
    double far_clip = 1e4;
    /// Sample point inside each pixel relative to the pixel's centre, in pixels, right and down, -0.5 to 0.5
    /// each. Different jitters per frame serve averages over frames.
    glm::dvec2 jitter{0.0};
    /// Offset of the image's middle from the view direction (the principal point), right and down, in widths
    /// and heights of the image, -1e5 to 1e5 each.
    glm::dvec2 shift{0.0};
    double pixel_aspect = 1;  ///< width of a pixel over its height on the image plane, 0.01 to 100

    bool operator==(const Camera&) const = default;
};

/// Returns the rotation and translation that put the camera at `origin`, looking at `target`, with `up`
/// upwards in the image. Throws Error(invalid_argument) if target equals origin or if up is parallel to the
/// view.
[[nodiscard]] glm::dmat4 look_at(const glm::dvec3& origin, const glm::dvec3& target, const glm::dvec3& up);

}  // namespace nicol
