// SPDX-License-Identifier: MIT
// The step along the rows of an image.
#pragma once

#include <vector>

#include "harmonics/transform.hpp"
#include "light/environment.hpp"

namespace nicol {

/// Fourier coefficients, over the azimuth of the propagation direction about the image's axes, of the rows
/// of `count` channels from `first` on, which are linear between pixels. Row i of a result lies at theta =
/// i pi / (height - 1), where i = 0 is the nadir of the image (its last row), for theta belongs to where
/// the light goes.
[[nodiscard]] std::vector<FourierRows> analyze_rows(const EquirectView& view, int first, int count,
                                                    int order);

}  // namespace nicol
