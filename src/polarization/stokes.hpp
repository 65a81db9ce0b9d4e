// SPDX-License-Identifier: MIT
// Stokes vectors and their frames.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace nicol {

/// Stokes vector (s0, s1, s2, s3) in units of radiance, in a frame whose z is the direction in which the
/// light travels. Seen by the receiver, s1 > 0 is linear along x, s2 > 0 linear at +45 degrees from x to y,
/// s3 > 0 right circular.
using Stokes = glm::dvec4;

/// A right-handed orthonormal frame; its columns are x, y, z.
using Frame = glm::dmat3;

/// Returns the components in the frame rotated by `angle` radians about z (Eq. 14):
/// s1 + i s2 gains exp(-2 i angle).
[[nodiscard]] Stokes rotated(const Stokes& s, double angle);

/// Returns the angle about the common z that rotates `from` into `to`: to = Rz(angle) from.
[[nodiscard]] double angle_between(const Frame& from, const Frame& to);

/// Returns the theta-phi frame field at a unit direction (Eq. 79): x = theta-hat, y = phi-hat, z = direction.
/// On the z axis phi is taken as 0.
[[nodiscard]] Frame theta_phi_frame(const glm::dvec3& direction);

/// Returns the frame with this unit z and an x as near as possible to `x_hint`, which must not be parallel to
/// z.
[[nodiscard]] Frame frame_with_x(const glm::dvec3& z, const glm::dvec3& x_hint);

}  // namespace nicol
