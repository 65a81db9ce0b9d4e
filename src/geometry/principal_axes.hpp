// SPDX-License-Identifier: MIT
// A frame that turns with what lies in it.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>

namespace nicol {

/// The principal axes of points as the columns of a rotation, the longest first, each towards the side where
/// the points reach farther (by third moments). Rotated or scaled points have rotated or the same axes, but
/// for rounding. Points without axes of their own, where two are nearly as long as each other or both sides
/// are alike, get the world's.
[[nodiscard]] glm::dmat3 principal_axes(std::span<const glm::vec3> points);

}  // namespace nicol
