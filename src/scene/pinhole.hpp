// SPDX-License-Identifier: MIT
// Pinhole cameras as computer vision has them, and cameras that frame a box.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "scene/camera.hpp"

namespace nicol {

/// Pinhole camera in OpenCV's convention: a point X of the world is at R X + t in the camera's axes, which
/// point right, down and forward, and (x, y, z) there is at the pixel (fx x / z + cx, fy y / z + cy). The
/// middle of the image's first pixel is at (0, 0).
struct Pinhole {
    glm::dvec2 focal{1};        ///< fx, fy, in pixels
    glm::dvec2 middle{0};       ///< cx, cy, in pixels
    glm::dmat3 rotation{1};     ///< R
    glm::dvec3 translation{0};  ///< t
};

/// Returns `camera` with the projection and the position of the pinhole camera of an image of width x height
/// pixels. Throws Error(invalid_argument) for numbers that are not finite, focal lengths that are not above
/// 0, and a rotation that is none.
[[nodiscard]] Camera with_pinhole(Camera camera, const Pinhole& pinhole, int width, int height);

/// Returns the inverse. Throws Error(invalid_argument) for a camera that is orthographic or not valid.
[[nodiscard]] Pinhole pinhole_of(const Camera& camera, int width, int height);

/// Returns `camera`, moved but not turned, so that the whole box from `lower` to `upper` is in its image of
/// width x height pixels and as large as it can be. The clip planes enclose the box; an orthographic camera
/// gets another size. Throws Error(invalid_argument) for a box that is a point or not finite, and for a
/// camera that is not valid.
[[nodiscard]] Camera framing(Camera camera, const glm::dvec3& lower, const glm::dvec3& upper, int width,
                             int height);

}  // namespace nicol
