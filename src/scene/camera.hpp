// SPDX-License-Identifier: MIT
// Cameras, as Mitsuba 3 defines them.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace nicol {

/// Camera space: +z forward, +y up, +x to the image's LEFT.
struct Camera {
    bool orthographic = false;
    /// Affine. A perspective camera must not be scaled; the lengths of the x and y axes are half the width of
    /// an orthographic image (its height follows from the aspect ratio; y scales that).
    glm::dmat4 to_world{1.0};
    double fov = 45;  ///< perspective: horizontal, degrees, in (0, 180)
    double near_clip = 1e-2;
    double far_clip = 1e4;
    /// Pixels, right and down, -0.5 to 0.5 each: what is that far from the centre of an image's pixel without
    /// jitter is at the centre with it. For averaging over frames.
    glm::dvec2 jitter{0.0};
    /// How far the middle of the image is from the view direction (its principal point), right and down, in
    /// widths and heights of the image, -1e5 to 1e5 each.
    glm::dvec2 shift{0.0};

    bool operator==(const Camera&) const = default;
};

/// A rotation and translation that puts the camera at `origin`, looking at `target`, with `up` upwards in the
/// image. Throws Error(invalid_argument) where target is origin or up is parallel to the view.
[[nodiscard]] glm::dmat4 look_at(const glm::dvec3& origin, const glm::dvec3& target, const glm::dvec3& up);

}  // namespace nicol
