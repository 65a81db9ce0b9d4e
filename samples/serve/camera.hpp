// SPDX-License-Identifier: MIT
// The camera and the light's rotation of a request.
#pragma once

#include <nicol.h>

#include "image_request.hpp"

/// Returns the world's axis nearest to this camera's up: 0 is x, 1 is y, 2 is z.
std::uint32_t vertical_axis(const nicol_camera& camera);

/// Returns the orbit of this camera about the point at distance `depth` in front of it. Numbers are rounded
/// to four digits, so that other machines give equal ones.
Orbit orbit_of(const nicol_camera& camera, std::uint32_t up, double depth);

/// Returns the scene's camera with the request's changes. Throws nicol::Error if the target is at the camera.
nicol_camera camera_of(const View& view, const nicol_camera& own, std::uint32_t up);

/// Computes the light's matrix: light_tilt after light, times the environment's matrix.
void rotate_light(const View& view, std::uint32_t up, const double own[16], double rotated[16]);
