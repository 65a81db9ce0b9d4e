// SPDX-License-Identifier: MIT
// Placements of surfaces that differ by a rotation and a shift.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <optional>

#include "scene/projection.hpp"

namespace nicol {

/// How far rotations may be off, relative: matrices may come from 32-bit floats.
inline constexpr double kRotationTolerance = 1e-6;

/// The proper rotation nearest to an invertible matrix, or to its negative where it mirrors: the rotation
/// in R * m is R times that in m.
[[nodiscard]] glm::dmat3 rotate_in(const glm::dmat3& m);

/// The motion with after = motion * before, where that is a proper rotation and a shift; exactly the identity
/// where both are equal. Both are affine and invertible.
[[nodiscard]] std::optional<glm::dmat4> rigid_motion(const glm::dmat4& before, const glm::dmat4& after);

/// Of a rigid motion.
[[nodiscard]] glm::dmat4 inverse_motion(const glm::dmat4& motion);

/// A projection of the world as one of axes that a rigid motion takes to the world's.
[[nodiscard]] Projection in_axes(const Projection& projection, const glm::dmat4& to_world);

}  // namespace nicol
