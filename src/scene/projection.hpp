// SPDX-License-Identifier: MIT
// From a camera to the numbers that drawing needs.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "polarization/viewpoint.hpp"
#include "scene/camera.hpp"

namespace nicol {

struct Projection {
    Viewpoint view;
    glm::dmat4 world_to_clip;  ///< OpenGL clip space, y up
    double half_width;  ///< of the image at unit distance (perspective), or in the world (orthographic)
    double half_height;
    glm::dvec2 pixel;  ///< the size of one, in clip space
    glm::dvec2 shift{
        0.0};  ///< of the image on the image plane, in half widths to the right and half heights up
    double sample_size = 1;  ///< of the square of a pixel that a sample stands for, in pixels: of textures
};

/// Where a point of an image of width x height pixels, (0, 0) its upper left corner, is on the image plane:
/// in units of right and up, at unit distance (perspective), or in the world's (orthographic).
[[nodiscard]] inline glm::dvec2 on_image_plane(const Projection& projection, int width, int height, double x,
                                               double y) {
    return {(2 * x / width - 1 + projection.shift.x) * projection.half_width,
            (1 - 2 * y / height + projection.shift.y) * projection.half_height};
}

/// The image moved on the image plane by so many pixels to the right and down.
[[nodiscard]] Projection jittered(Projection projection, const glm::dvec2& pixels);

/// Throws Error(invalid_argument) naming the member of the camera that is out of range, or `to_world` where
/// it is not finite, not affine, mirrors, or is not orthogonal.
[[nodiscard]] Projection project(const Camera& camera, int width, int height);

}  // namespace nicol
