// SPDX-License-Identifier: MIT
#include "reference/camera_rays.hpp"

#include <glm/geometric.hpp>

namespace nicol {

CameraRays::CameraRays(const Projection& projection, int width, int height)
    : projection_(projection), width_(width), height_(height) {}

Ray CameraRays::through(double x, double y) const {
    const Viewpoint& view = projection_.view;
    const glm::dvec2 at = on_image_plane(projection_, width_, height_, x, y);
    const glm::dvec3 across = at.x * view.right + at.y * view.up;
    Ray ray;
    ray.origin = view.orthographic ? view.eye + across : view.eye;
    ray.direction = view.orthographic ? view.forward : glm::normalize(view.forward + across);
    const double along_view = glm::dot(ray.direction, view.forward);
    ray.nearest = projection_.near_clip / along_view;
    ray.farthest = projection_.far_clip / along_view;
    return ray;
}

}  // namespace nicol
