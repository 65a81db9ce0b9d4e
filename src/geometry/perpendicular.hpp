// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace nicol {

/// Returns a unit vector perpendicular to the unit vector n: the one Mitsuba takes (Duff et al., Building an
/// Orthonormal Basis, Revisited, 2017).
[[nodiscard]] inline glm::dvec3 perpendicular(const glm::dvec3& n) {
    const double sign = std::copysign(1.0, n.z);
    const double a = -1.0 / (sign + n.z);
    return {1.0 + sign * n.x * n.x * a, sign * n.x * n.y * a, -sign * n.x};
}

/// Returns the unit vector perpendicular to n that is nearest to `along`; perpendicular(n) if `along` is
/// parallel to n.
[[nodiscard]] inline glm::dvec3 perpendicular(const glm::dvec3& n, const glm::dvec3& along) {
    const glm::dvec3 across = along - glm::dot(along, n) * n;
    const double length = glm::length(across);
    return length > 1e-6 * glm::length(along) ? across / length : perpendicular(n);
}

}  // namespace nicol
