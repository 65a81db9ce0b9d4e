// SPDX-License-Identifier: MIT
// Limit of the world coordinates of surfaces.
#pragma once

namespace nicol {

/// Largest absolute coordinate of a vertex. The limit exists because Embree multiplies coordinates in single
/// precision.
inline constexpr float kLargestCoordinate = 1e15F;

}  // namespace nicol
