// SPDX-License-Identifier: MIT
#include "devices/mirrored_pixel.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

// Largest distance between a sample's place and the point that is shaded for it, in samples. Points that are
// farther away are not of the sample's surface.
constexpr double kFarthest = 1;

}  // namespace

glm::dvec3 bend_of_normal(const ShownTriangle& triangle, const glm::dvec3& way, const glm::dvec3& normal) {
    const glm::dvec3 corner(triangle.corners[0]);
    const glm::dvec3 second = glm::dvec3(triangle.corners[1]) - corner;
    const glm::dvec3 third = glm::dvec3(triangle.corners[2]) - corner;
    const glm::dvec3 across = glm::cross(second, third);
    const double area2 = glm::dot(across, across);
    if (!(area2 > 0)) return glm::dvec3(0.0);
    const double along_second = glm::dot(glm::cross(way, third), across) / area2;
    const double along_third = glm::dot(glm::cross(second, way), across) / area2;
    const glm::dvec3 first(triangle.normals[0]);
    const glm::dvec3 here = along_second * (glm::dvec3(triangle.normals[1]) - first) +
                            along_third * (glm::dvec3(triangle.normals[2]) - first);
    return here - glm::dot(here, normal) * normal;
}

MirroredPixel mirrored_pixel(const Projection& projection, int width, int height,
                             const ShownTriangle& triangle, const glm::vec3& position,
                             const glm::vec3& normal, const glm::dvec2& middle) {
    const Viewpoint& view = projection.view;
    const glm::dvec3 away = glm::dvec3(position) - view.eye;
    const glm::dvec3 sight = -view.towards(glm::dvec3(position));
    const glm::dvec3 n(normal);
    const glm::dvec3 facet(triangle.facet);
    const double seen = glm::dot(sight, facet);
    const double depth = view.orthographic ? 1 : glm::dot(away, view.forward);
    // On the image plane, which is at unit distance in a perspective view.
    const glm::dvec2 sample(2 * projection.sample_size * projection.half_width / width,
                            -2 * projection.sample_size * projection.half_height / height);
    const std::array<glm::dvec3, 2> across{view.right * sample.x, view.up * sample.y};
    MirroredPixel out;
    for (std::size_t i = 0; i < 2; ++i) {
        const glm::dvec3 upright = across[i] - glm::dot(across[i], sight) * sight;
        const glm::dvec3 turn = view.orthographic ? glm::dvec3(0.0) : upright * (depth / glm::length(away));
        glm::dvec3 way = upright * depth;
        if (std::abs(seen) > 1e-3) way -= glm::dot(way, facet) / seen * sight;
        const glm::dvec3 bent = bend_of_normal(triangle, way, n);
        const glm::dvec3 step =
            turn - 2 * (glm::dot(turn, n) + glm::dot(sight, bent)) * n - 2 * glm::dot(sight, n) * bent;
        const double length = glm::length(step);
        if (!std::isfinite(length)) continue;
        out.steps[i] = glm::vec3(step / std::max(1.0, length));
    }
    const glm::dvec2 shown = glm::dvec2(glm::dot(away, view.right), glm::dot(away, view.up)) / depth;
    const glm::dvec2 beside = (middle - shown) / sample;
    if (!(glm::length(beside) < kFarthest)) return out;
    out.shift = static_cast<float>(beside.x) * out.steps[0] + static_cast<float>(beside.y) * out.steps[1];
    return out;
}

}  // namespace nicol
