// SPDX-License-Identifier: MIT
// PSH coefficients of an equirectangular image.
#pragma once

#include "light/environment.hpp"

namespace nicol {

/// Coefficients over propagation directions in the world's axes of the function that is bilinear between
/// these pixels, at least 2 x 2: not of the pixels as points, so that light and background agree at any
/// resolution.
[[nodiscard]] PshVector project_equirect(const EquirectView& view, int order);

}  // namespace nicol
