// SPDX-License-Identifier: MIT
// Placements of surfaces that differ by a rotation and a shift.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "scene/projection.hpp"

namespace nicol {

/// Relative tolerance for rotations, because matrices may come from 32-bit floats.
inline constexpr double kRotationTolerance = 1e-6;

/// Returns the proper rotation nearest to an invertible matrix, or to its negative if the matrix mirrors. The
/// rotation in R * m is R times the rotation in m.
[[nodiscard]] glm::dmat3 rotate_in(const glm::dmat3& m);
/// Returns the rotation from one placement to another, exactly 1 if their linear parts are equal.
[[nodiscard]] glm::dmat3 rotation_between(const glm::dmat4& before, const glm::dmat4& after);

/// Returns the motion with after = motion * before, or none if this is not a proper rotation and a shift;
/// exactly the identity if `before` equals `after`. Both matrices must be affine and invertible.
[[nodiscard]] std::optional<glm::dmat4> rigid_motion(const glm::dmat4& before, const glm::dmat4& after);

/// Returns the inverse of a rigid motion.
[[nodiscard]] glm::dmat4 inverse_motion(const glm::dmat4& motion);

/// Returns a projection of the world as a projection of axes that the rigid motion `to_world` takes to the
/// world's axes.
[[nodiscard]] Projection in_axes(const Projection& projection, const glm::dmat4& to_world);

}  // namespace nicol
