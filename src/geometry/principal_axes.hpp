// SPDX-License-Identifier: MIT
// Coordinate frame that rotates with the points it is made from.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace nicol {

/// Returns the principal axes of points as the columns of a rotation, the longest first, each towards the
/// side of the larger third moment. Rotating the points rotates the axes; scaling them keeps the axes.
/// Returns the identity if two variances are nearly equal or a third moment nearly vanishes, because the axes
/// would be arbitrary.
[[nodiscard]] glm::dmat3 principal_axes(std::span<const glm::vec3> points);

}  // namespace nicol
