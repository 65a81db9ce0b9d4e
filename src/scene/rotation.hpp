// SPDX-License-Identifier: MIT
// Rotations in transforms of lights.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>

namespace nicol {

/// Returns the rotation of an affine matrix whose axes are at right angles. Throws Error(invalid_argument)
/// that names `what` for any other matrix.
[[nodiscard]] glm::dmat3 rotation_of(const glm::dmat4& to_world, const char* what);

}  // namespace nicol
