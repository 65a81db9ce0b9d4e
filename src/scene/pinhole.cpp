// SPDX-License-Identifier: MIT
#include "scene/pinhole.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vector_relational.hpp>
#include <limits>
#include <numbers>
#include <string>

#include "arguments.hpp"
#include "scene/projection.hpp"

namespace nicol {
namespace {

void check(const Pinhole& pinhole) {
    if (!(pinhole.focal.x > 0 && pinhole.focal.y > 0 && std::isfinite(pinhole.focal.x + pinhole.focal.y)))
        refuse("the focal lengths are " + std::to_string(pinhole.focal.x) + " and " +
               std::to_string(pinhole.focal.y) + " pixels; they must be finite and above 0");
    if (!std::isfinite(pinhole.middle.x + pinhole.middle.y)) refuse("the principal point must be finite");
    if (!std::isfinite(glm::dot(pinhole.translation, pinhole.translation))) refuse("t must be finite");
    const glm::dmat3 product = pinhole.rotation * glm::transpose(pinhole.rotation);
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if (!(std::abs(product[i][j] - (i == j ? 1 : 0)) < 1e-4))
                refuse("R is no rotation: its rows must have length 1 and be at right angles");
    if (glm::determinant(pinhole.rotation) < 0) refuse("R mirrors; it must be a rotation");
}

/// Smallest and largest of several numbers.
struct Extent {
    double least = std::numeric_limits<double>::infinity();
    double most = -std::numeric_limits<double>::infinity();

    void add(double x) {
        least = std::min(least, x);
        most = std::max(most, x);
    }
};

std::array<glm::dvec3, 8> corners_of(const glm::dvec3& lower, const glm::dvec3& upper) {
    std::array<glm::dvec3, 8> corners{};
    for (std::size_t i = 0; i < 8; ++i)
        corners[i] = {(i & 1) != 0 ? upper.x : lower.x, (i & 2) != 0 ? upper.y : lower.y,
                      (i & 4) != 0 ? upper.z : lower.z};
    return corners;
}

/// Positions of a camera whose image encloses the corners along one axis: its place along the axis lies
/// between first + slope.x * depth and last - slope.y * depth, where depth is its place along the view.
struct Places {
    double first, last;
    glm::dvec2 slope;

    [[nodiscard]] double farthest_ahead() const { return (last - first) / (slope.x + slope.y); }
    [[nodiscard]] double middle(double depth) const {
        return 0.5 * (first + slope.x * depth + last - slope.y * depth);
    }
};

/// half: half the image's size at unit distance; shift: offset of its middle in these.
Places places(const std::array<glm::dvec3, 8>& corners, const glm::dvec3& axis, const glm::dvec3& forward,
              double half, double shift) {
    const glm::dvec2 slope(half * (1 + shift), half * (1 - shift));
    Extent towards_first, towards_last;
    for (const glm::dvec3& corner : corners) {
        towards_first.add(glm::dot(corner, axis) - slope.x * glm::dot(corner, forward));
        towards_last.add(glm::dot(corner, axis) + slope.y * glm::dot(corner, forward));
    }
    return {.first = towards_first.most, .last = towards_last.least, .slope = slope};
}

}  // namespace

Camera with_pinhole(Camera camera, const Pinhole& pinhole, int width, int height) {
    check(pinhole);
    camera.orthographic = false;
    camera.fov = 360 / std::numbers::pi * std::atan(width / (2 * pinhole.focal.x));
    camera.pixel_aspect = pinhole.focal.y / pinhole.focal.x;
    camera.shift = 0.5 - (pinhole.middle + 0.5) / glm::dvec2(width, height);
    const glm::dmat3 axes = glm::transpose(pinhole.rotation);  // right, down, forward in the world
    const glm::dvec3 place = -(axes * pinhole.translation);
    camera.to_world = {glm::dvec4(-axes[0], 0), glm::dvec4(-axes[1], 0), glm::dvec4(axes[2], 0),
                       glm::dvec4(place, 1)};
    static_cast<void>(project(camera, width, height));  // checks it
    return camera;
}

Pinhole pinhole_of(const Camera& camera, int width, int height) {
    if (camera.orthographic) refuse("the camera is orthographic; it has no focal length");
    const Projection projection = project(camera, width, height);
    const Viewpoint& view = projection.view;
    Pinhole pinhole;
    pinhole.focal =
        glm::dvec2(width, height) / (2.0 * glm::dvec2(projection.half_width, projection.half_height));
    pinhole.middle = (0.5 - camera.shift) * glm::dvec2(width, height) - 0.5;
    pinhole.rotation = glm::transpose(glm::dmat3(view.right, -view.up, view.forward));
    pinhole.translation = -(pinhole.rotation * view.eye);
    return pinhole;
}

Camera framing(Camera camera, const glm::dvec3& lower, const glm::dvec3& upper, int width, int height) {
    const glm::dvec3 size = upper - lower;
    if (!std::isfinite(glm::dot(size, size)) || !(glm::dot(size, size) > 0) ||
        glm::any(glm::lessThan(size, glm::dvec3(0))))
        refuse("the box must be finite and larger than a point, with its lower corner first");
    Camera still = camera;
    still.jitter = {};
    const Projection now = project(still, width, height);
    const Viewpoint& view = now.view;
    const std::array<glm::dvec3, 8> corners = corners_of(lower, upper);
    Extent right, up, ahead;
    for (const glm::dvec3& corner : corners) {
        right.add(glm::dot(corner, view.right));
        up.add(glm::dot(corner, view.up));
        ahead.add(glm::dot(corner, view.forward));
    }
    const double radius = 0.5 * glm::length(size);
    glm::dvec3 place{};  // along right, up and forward
    if (camera.orthographic) {
        const double scale =
            std::max({(right.most - right.least) / (2 * now.half_width),
                      (up.most - up.least) / (2 * now.half_height), 1e-6 * radius / now.half_width});
        for (int axis = 0; axis < 2; ++axis) camera.to_world[axis] *= scale;
        const glm::dvec2 middle(0.5 * (right.least + right.most), 0.5 * (up.least + up.most));
        place = {middle - scale * now.shift * glm::dvec2(now.half_width, now.half_height),
                 ahead.least - 2 * radius};
    } else {
        const Places across = places(corners, view.right, view.forward, now.half_width, now.shift.x);
        const Places along = places(corners, view.up, view.forward, now.half_height, now.shift.y);
        const double depth =
            std::min({across.farthest_ahead(), along.farthest_ahead(), ahead.least - 0.01 * radius});
        place = {across.middle(depth), along.middle(depth), depth};
    }
    const glm::dvec3 eye = view.right * place.x + view.up * place.y + view.forward * place.z;
    camera.to_world[3] = glm::dvec4(eye, 1);
    const double nearest = ahead.least - place.z, farthest = ahead.most - place.z;
    camera.near_clip = std::max(0.5 * nearest, 1e-3 * radius);
    if (std::isfinite(camera.far_clip)) camera.far_clip = 2 * farthest + radius;
    static_cast<void>(project(camera, width, height));  // checks it
    return camera;
}

}  // namespace nicol
