// SPDX-License-Identifier: MIT
// The camera and the light's rotation of a request.
#pragma once

#include <nicol.h>

#include "image_request.hpp"

/// 0 is x, 1 is y, 2 is z: the world's axis that this camera's up comes nearest to.
std::uint32_t vertical_axis(const nicol_camera& camera);

/// How this camera orbits the point that lies so far in front of it; numbers are rounded to four digits, so
/// that they are the same on other machines.
Orbit orbit_of(const nicol_camera& camera, std::uint32_t up, double depth);

/// The scene's own camera, changed as the request says. Throws nicol::Error if the target is at the camera.
nicol_camera camera_of(const View& view, const nicol_camera& own, std::uint32_t up);

/// light_tilt after light, times the environment's own matrix.
void rotate_light(const View& view, std::uint32_t up, const double own[16], double rotated[16]);
