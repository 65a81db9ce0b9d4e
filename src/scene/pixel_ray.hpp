// SPDX-License-Identifier: MIT
// Rays from a camera through points of an image.
#pragma once

#include <glm/geometric.hpp>

#include "geometry/ray_scene.hpp"
#include "scene/projection.hpp"

namespace nicol {

/// Returns the ray through a point of an image, as in on_image_plane(), between the clipping planes.
[[nodiscard]] inline Ray pixel_ray(const Projection& projection, int width, int height, double x, double y) {
    const Viewpoint& view = projection.view;
    const glm::dvec2 at = on_image_plane(projection, width, height, x, y);
    const glm::dvec3 beside = at.x * view.right + at.y * view.up;
    Ray ray{.origin = view.orthographic ? view.eye + beside : view.eye,
            .direction = view.orthographic ? view.forward : glm::normalize(view.forward + beside)};
    const double along = glm::dot(ray.direction, view.forward);
    ray.nearest = projection.near_clip / along;
    ray.farthest = projection.far_clip / along;
    return ray;
}

}  // namespace nicol
