// SPDX-License-Identifier: MIT
// Transport of the axes of frames between directions.
#pragma once

#include <glm/geometric.hpp>

namespace nicol {

/// Returns an axis perpendicular to a unit direction, moved to another direction along the shortest way.
template <class Vector>
[[nodiscard]] Vector moved(const Vector& axis, const Vector& from, const Vector& to) {
    return axis - glm::dot(axis, to) / (1 + glm::dot(from, to)) * (from + to);
}

}  // namespace nicol
