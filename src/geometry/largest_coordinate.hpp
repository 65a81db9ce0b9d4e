// SPDX-License-Identifier: MIT
// How far from the origin of the world surfaces may be.
#pragma once

namespace nicol {

/// Embree multiplies coordinates in single precision.
inline constexpr float kLargestCoordinate = 1e15F;

}  // namespace nicol
