// SPDX-License-Identifier: MIT
#include "reference/camera_rays.hpp"

#include "scene/pixel_ray.hpp"

namespace nicol {

CameraRays::CameraRays(const Projection& projection, int width, int height)
    : projection_(projection), width_(width), height_(height) {}

Ray CameraRays::through(double x, double y) const {
    return pixel_ray(projection_, width_, height_, x, y);
}

}  // namespace nicol
