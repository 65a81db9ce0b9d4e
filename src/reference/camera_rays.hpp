// SPDX-License-Identifier: MIT
// Camera rays of an image.
#pragma once

#include "geometry/ray_scene.hpp"
#include "scene/projection.hpp"

namespace nicol {

/// Rays through an image of width x height pixels, between the clip planes of the projection.
class CameraRays {
public:
    CameraRays(const Projection& projection, int width, int height);

    /// Returns the ray through the image at (x, y), in pixels from the image's upper left corner.
    [[nodiscard]] Ray through(double x, double y) const;
    /// Returns the frame in which the light along a ray is measured.
    [[nodiscard]] Frame frame(const Ray& ray) const { return projection_.view.frame(-ray.direction); }

private:
    Projection projection_;
    int width_, height_;
};

}  // namespace nicol
