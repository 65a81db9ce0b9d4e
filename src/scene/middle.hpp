// SPDX-License-Identifier: MIT
// Origin of the coordinates in which a scene's surfaces are computed.
#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>

#include "scene/scene.hpp"

namespace nicol {

/// Returns the index of the scene's instance with the most vertices. There must be an instance.
[[nodiscard]] std::size_t largest_instance(const Scene& scene);

/// Returns the origin for single-precision coordinates around an instance: the middle of its box, rounded to
/// multiples of eight times its size. The rounding leaves scenes near the world's origin as they are, and
/// makes differences from the origin exact in double precision. The world's origin if the instance lies
/// beyond the range of coordinates.
[[nodiscard]] glm::dvec3 middle_of(const Instance& instance);

/// Returns the transform from the world to coordinates whose origin is `middle`.
[[nodiscard]] glm::dmat4 from_middle(const glm::dvec3& middle);

}  // namespace nicol
