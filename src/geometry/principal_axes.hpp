// SPDX-License-Identifier: MIT
// A frame that turns with what lies in it.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace nicol {

/// The principal axes of points as the columns of a rotation, the longest first, each towards the side where
/// the points reach farther (by third moments). Turned points have turned axes, but for rounding; where two
/// axes are as long as each other, or fewer than two points are given, any that fit.
[[nodiscard]] glm::dmat3 principal_axes(std::span<const glm::vec3> points);

}  // namespace nicol
