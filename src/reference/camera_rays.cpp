// SPDX-License-Identifier: MIT
#include "reference/camera_rays.hpp"

#include <algorithm>
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
    // Clip z and w are linear along the ray. The clip planes are z = -w and z = w.
    const glm::dvec4 start = projection_.world_to_clip * glm::dvec4(ray.origin, 1);
    const glm::dvec4 step = projection_.world_to_clip * glm::dvec4(ray.direction, 0);
    ray.nearest = std::max(0.0, -(start.z + start.w) / (step.z + step.w));
    ray.farthest = (start.w - start.z) / (step.z - step.w);
    return ray;
}

}  // namespace nicol
