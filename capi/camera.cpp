// SPDX-License-Identifier: MIT
// Cameras.
#include "camera.hpp"

#include <algorithm>
#include <utility>

#include "assets.hpp"
#include "initialiser.hpp"
#include "scene/pinhole.hpp"

using namespace nicol;
using namespace nicol::capi;

namespace {

nicol_camera read_camera(const nicol_camera* camera) {
    return read_struct(camera, nicol_camera NICOL_CAMERA_INIT, "camera");
}

/// Returns the sides of an image.
std::pair<int, int> sides(std::uint32_t width, std::uint32_t height) {
    require_size("an image", width, height);
    return {static_cast<int>(width), static_cast<int>(height)};
}

glm::dvec3 vector(const double* values) {
    return {values[0], values[1], values[2]};
}

Pinhole pinhole_from(const double* k, const double* r, const double* t) {
    constexpr int zeros[] = {1, 3, 6, 7};
    for (const int i : zeros) {
        if (k[i] != 0) {
            refuse("K[" + std::to_string(i) + "] is " + std::to_string(k[i]) +
                   "; it must be 0: K is fx 0 cx, 0 fy cy, 0 0 1, without skew");
        }
    }
    if (k[8] != 1) refuse("K[8] is " + std::to_string(k[8]) + "; it must be 1");
    Pinhole pinhole{.focal = {k[0], k[4]}, .middle = {k[2], k[5]}, .translation = vector(t)};
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column) pinhole.rotation[column][row] = r[3 * row + column];
    return pinhole;
}

}  // namespace

namespace nicol::capi {

Camera camera_from(const nicol_camera& given) {
    if (given.projection > NICOL_PROJECTION_ORTHOGRAPHIC) {
        refuse("camera->projection is " + std::to_string(given.projection) +
               "; it must be one of NICOL_PROJECTION_...");
    }
    Camera camera;
    camera.orthographic = given.projection == NICOL_PROJECTION_ORTHOGRAPHIC;
    camera.to_world = matrix(given.to_world);
    camera.fov = given.fov;
    camera.near_clip = given.near_clip;
    camera.far_clip = given.far_clip;
    camera.jitter = {given.jitter[0], given.jitter[1]};
    camera.shift = {given.shift[0], given.shift[1]};
    camera.pixel_aspect = given.pixel_aspect;
    return camera;
}

nicol_camera camera_to(const Camera& camera) {
    nicol_camera out = NICOL_CAMERA_INIT;
    out.projection = camera.orthographic ? NICOL_PROJECTION_ORTHOGRAPHIC : NICOL_PROJECTION_PERSPECTIVE;
    write_matrix(camera.to_world, out.to_world);
    out.fov = camera.fov;
    out.near_clip = camera.near_clip;
    out.far_clip = camera.far_clip;
    out.jitter[0] = camera.jitter.x;
    out.jitter[1] = camera.jitter.y;
    out.shift[0] = camera.shift.x;
    out.shift[1] = camera.shift.y;
    out.pixel_aspect = camera.pixel_aspect;
    return out;
}

}  // namespace nicol::capi

nicol_result nicol_camera_look_at(nicol_camera* camera, const double origin[3], const double target[3],
                                  const double up[3]) {
    return guarded([&] {
        nicol_camera out = read_camera(camera);
        require(origin, "origin");
        require(target, "target");
        require(up, "up");
        write_matrix(look_at({origin[0], origin[1], origin[2]}, {target[0], target[1], target[2]},
                             {up[0], up[1], up[2]}),
                     out.to_world);
        write_struct(camera, out, "camera");
    });
}

nicol_result nicol_camera_set_opencv(nicol_camera* camera, const double K[9], const double R[9],
                                     const double t[3], uint32_t width, uint32_t height) {
    return guarded([&] {
        const Camera former = camera_from(read_camera(camera));
        require(K, "K");
        require(R, "R");
        require(t, "t");
        const auto [columns, rows] = sides(width, height);
        write_struct(camera, camera_to(with_pinhole(former, pinhole_from(K, R, t), columns, rows)), "camera");
    });
}

nicol_result nicol_camera_get_opencv(const nicol_camera* camera, uint32_t width, uint32_t height, double K[9],
                                     double R[9], double t[3]) {
    return guarded([&] {
        const Camera from = camera_from(read_camera(camera));
        require(K, "K");
        require(R, "R");
        require(t, "t");
        const auto [columns, rows] = sides(width, height);
        const Pinhole pinhole = pinhole_of(from, columns, rows);
        const double k[9] = {
            pinhole.focal.x, 0, pinhole.middle.x, 0, pinhole.focal.y, pinhole.middle.y, 0, 0, 1};
        std::copy_n(k, 9, K);
        for (int row = 0; row < 3; ++row) {
            for (int column = 0; column < 3; ++column) R[3 * row + column] = pinhole.rotation[column][row];
            t[row] = pinhole.translation[row];
        }
    });
}

nicol_result nicol_camera_frame(nicol_camera* camera, const double lower[3], const double upper[3],
                                uint32_t width, uint32_t height) {
    return guarded([&] {
        const Camera former = camera_from(read_camera(camera));
        require(lower, "lower");
        require(upper, "upper");
        const auto [columns, rows] = sides(width, height);
        write_struct(camera, camera_to(framing(former, vector(lower), vector(upper), columns, rows)),
                     "camera");
    });
}

NICOL_INITIALISER(nicol_camera, NICOL_CAMERA_INIT)
