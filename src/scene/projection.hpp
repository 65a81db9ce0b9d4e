// SPDX-License-Identifier: MIT
// Projection of a camera onto an image.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>

#include "polarization/viewpoint.hpp"
#include "scene/camera.hpp"

namespace nicol {

struct Projection {
    Viewpoint view;
    /// Clip space, y up. Depth is reversed: 1 at the near plane and 0 at the far plane.
    glm::dmat4 world_to_clip;
    double near_clip;   ///< distances along the view direction
    double far_clip;    ///< infinity: no far plane
    double half_width;  ///< half the image's width at unit distance (perspective), or in the world
                        ///< (orthographic)
    double half_height;
    glm::dvec2 pixel;  ///< size of one pixel in clip space
    /// Offset of the image on the image plane, in half widths to the right and half heights up.
    glm::dvec2 shift{0.0};
    double sample_size = 1;   ///< side of the square that one sample covers, in pixels
    double texture_size = 1;  ///< side of the square over which textures are averaged, in pixels
};

/// Returns the position on the image plane of a point of an image of width x height pixels, whose upper left
/// corner is (0, 0). The position is in units of right and up, at unit distance (perspective) or in the world
/// (orthographic).
[[nodiscard]] inline glm::dvec2 on_image_plane(const Projection& projection, int width, int height, double x,
                                               double y) {
    return {(2 * x / width - 1 + projection.shift.x) * projection.half_width,
            (1 - 2 * y / height + projection.shift.y) * projection.half_height};
}

/// Returns the projection whose image is moved on the image plane by `pixels` to the right and down.
[[nodiscard]] Projection jittered(Projection projection, const glm::dvec2& pixels);

/// Throws Error(invalid_argument) that names the camera's member that is out of range, or `to_world` if it is
/// not finite, not affine, mirrors, or is not orthogonal.
[[nodiscard]] Projection project(const Camera& camera, int width, int height);

}  // namespace nicol
