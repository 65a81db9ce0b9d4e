// SPDX-License-Identifier: MIT
// Visibility below the horizon.
#pragma once

namespace nicol {

/// What the visibility of a vertex is taken for below its horizon, where nothing reflects, before it is
/// truncated to harmonics.
enum class HorizonExtension {
    dark,      ///< 0, as the paper has it
    mirrored,  ///< V(x, y, -z) = V(x, y, z): no step at the horizon, and only even l + m
};

}  // namespace nicol
