// SPDX-License-Identifier: MIT
// Length of light's paths to the camera.
#pragma once

#include <climits>

namespace nicol {

// The depth of a path is its number of segments from a light to the camera, as in Mitsuba: light that the
// camera sees directly has depth 1.

/// Depth of light that a surface reflects once.
inline constexpr int kDirectLightDepth = 2;
/// Depth that no path exceeds.
inline constexpr int kUnlimitedDepth = INT_MAX;

}  // namespace nicol
