// SPDX-License-Identifier: MIT
#include "scene/projection.hpp"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <numbers>
#include <string>

#include "arguments.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse_camera(const std::string& message) {
    refuse("camera: " + message);
}

void check_axes(const glm::dmat4& m) {
    for (int column = 0; column < 4; ++column) {
        for (int row = 0; row < 4; ++row) {
            if (!std::isfinite(m[column][row])) refuse_camera("to_world has an element that is not finite");
        }
    }
    if (m[0][3] != 0 || m[1][3] != 0 || m[2][3] != 0 || m[3][3] != 1) {
        refuse_camera("the last row of to_world must be 0 0 0 1");
    }
    const glm::dmat3 axes(m);
    for (int i = 0; i < 3; ++i) {
        const double length = glm::length(axes[i]);
        if (!(length > 1e-12) || !std::isfinite(length)) refuse_camera("to_world has an axis without length");
    }
    for (int i = 0; i < 3; ++i) {
        const glm::dvec3 a = glm::normalize(axes[i]);
        const glm::dvec3 b = glm::normalize(axes[(i + 1) % 3]);
        if (std::abs(glm::dot(a, b)) > 1e-4) refuse_camera("the axes of to_world must be at right angles");
    }
    if (glm::determinant(axes) < 0)
        refuse_camera("to_world mirrors; it must keep right-handed axes right-handed");
}

}  // namespace

glm::dmat4 look_at(const glm::dvec3& origin, const glm::dvec3& target, const glm::dvec3& up) {
    const glm::dvec3 forward = target - origin;
    const glm::dvec3 left = glm::cross(up, forward);
    const double scale = glm::length(up) * glm::length(forward);
    if (!(glm::length(left) > 1e-9 * scale) || !std::isfinite(scale)) {
        refuse_camera("look_at needs a target apart from the origin and an up that is not along the view");
    }
    const glm::dvec3 z = glm::normalize(forward);
    const glm::dvec3 x = glm::normalize(left);
    return {glm::dvec4(x, 0), glm::dvec4(glm::cross(z, x), 0), glm::dvec4(z, 0), glm::dvec4(origin, 1)};
}

Projection jittered(Projection projection, const glm::dvec2& pixels) {
    const glm::dvec2 shift = pixels * projection.pixel * glm::dvec2(1, -1);
    projection.shift += shift;
    for (int column = 0; column < 4; ++column) {
        glm::dvec4& m = projection.world_to_clip[column];
        m.x -= shift.x * m.w;
        m.y -= shift.y * m.w;
    }
    return projection;
}

Projection project(const Camera& camera, int width, int height) {
    check_axes(camera.to_world);
    const double near = camera.near_clip;
    const double far = camera.far_clip;
    if (!(near > 0 && far > near && (std::isfinite(far) || !camera.orthographic))) {
        refuse_camera(
            "near_clip is " + std::to_string(near) + " and far_clip " + std::to_string(far) +
            "; they must satisfy 0 < near_clip < far_clip, which may be infinite for a perspective camera");
    }
    if (!(std::abs(camera.jitter.x) <= 0.5 && std::abs(camera.jitter.y) <= 0.5)) {
        refuse_camera("jitter is " + std::to_string(camera.jitter.x) + " " + std::to_string(camera.jitter.y) +
                      "; each must lie in -0.5 to 0.5");
    }
    if (!(std::abs(camera.shift.x) <= 1e5 && std::abs(camera.shift.y) <= 1e5)) {
        refuse_camera("shift is " + std::to_string(camera.shift.x) + " " + std::to_string(camera.shift.y) +
                      "; each must lie in -100000 to 100000");
    }
    const glm::dmat3 axes(camera.to_world);
    if (!(camera.pixel_aspect >= 0.01 && camera.pixel_aspect <= 100)) {
        refuse_camera("pixel_aspect is " + std::to_string(camera.pixel_aspect) +
                      "; it must lie in 0.01 to 100");
    }
    const double aspect = camera.pixel_aspect * width / height;

    Projection p;
    p.view.orthographic = camera.orthographic;
    p.view.eye = glm::dvec3(camera.to_world[3]);
    p.view.forward = glm::normalize(axes[2]);
    p.view.up = glm::normalize(axes[1]);
    p.view.right = -glm::normalize(axes[0]);

    // Rows of the matrix: right, up, backward, the axes of OpenGL's eye space.
    const glm::dmat3 rotation = glm::transpose(glm::dmat3(p.view.right, p.view.up, -p.view.forward));
    glm::dmat4 world_to_eye(rotation);
    world_to_eye[3] = glm::dvec4(-(rotation * p.view.eye), 1);

    glm::dmat4 clip(0.0);
    if (camera.orthographic) {
        p.half_width = glm::length(axes[0]);
        p.half_height = glm::length(axes[1]) / aspect;
        clip[0][0] = 1 / p.half_width;
        clip[1][1] = 1 / p.half_height;
        clip[2][2] = 1 / (far - near);
        clip[3][2] = far / (far - near);
        clip[3][3] = 1;
    } else {
        if (!(camera.fov > 0 && camera.fov < 180)) {
            refuse_camera("fov is " + std::to_string(camera.fov) + "; it must lie between 0 and 180 degrees");
        }
        p.half_width = std::tan(camera.fov * std::numbers::pi / 360);
        p.half_height = p.half_width / aspect;
        clip[0][0] = 1 / p.half_width;
        clip[1][1] = 1 / p.half_height;
        const double ratio = near / far;  // 0 without a far plane
        clip[2][2] = ratio / (1 - ratio);
        clip[3][2] = near / (1 - ratio);
        clip[2][3] = -1;
    }
    p.world_to_clip = clip * world_to_eye;
    p.near_clip = near;
    p.far_clip = far;
    p.pixel = {2.0 / width, 2.0 / height};
    return jittered(p, camera.jitter + camera.shift * glm::dvec2(width, height));
}

}  // namespace nicol
