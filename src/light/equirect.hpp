// SPDX-License-Identifier: MIT
// The mapping between directions and equirectangular images (see EquirectImage).
#pragma once

#include <glm/vec2.hpp>

#include "polarization/stokes.hpp"

namespace nicol {

/// Returns the unit direction towards the light at (u, v).
[[nodiscard]] glm::dvec3 equirect_direction(double u, double v);

/// Returns (u, v) of a unit direction towards the light: 0 <= u < 1, 0 <= v <= 1. At the zenith and nadir u
/// is 0.
[[nodiscard]] glm::dvec2 equirect_coordinates(const glm::dvec3& towards_light);

/// Returns the Stokes frame of the image at (u, v): z = propagation, x = the horizontal direction of
/// increasing u.
[[nodiscard]] Frame equirect_frame(double u, double v);

/// Returns the integral over the sphere of an image of width x height pixels in which one pixel of this row
/// is 1 and all other pixels are 0.
[[nodiscard]] double pixel_solid_angle(int width, int height, int row);

/// Returns the axes (as columns) about which the image's rows are circles of latitude: z = world y, x = world
/// -z, y = world -x. About these axes, a propagation direction has theta = pi (1 - v) and phi = pi - 2 pi u,
/// and its image frame is its theta-phi frame rotated by +90 degrees: x = phi-hat, y = -theta-hat.
[[nodiscard]] glm::dmat3 equirect_axes();

}  // namespace nicol
