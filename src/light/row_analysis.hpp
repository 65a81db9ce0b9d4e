// SPDX-License-Identifier: MIT
// The step along the rows of a picture.
#pragma once

#include <vector>

#include "nicol/environment.hpp"
#include "nicol/transform.hpp"

namespace nicol {

/// Fourier coefficients, over the azimuth of the propagation direction about the picture's axes, of the rows
/// of `count` channels from `first` on, which are linear between pixels. Row i of a result lies at theta =
/// i pi / (height - 1), where i = 0 is the nadir of the picture (its last row), for theta belongs to where
/// the light goes.
[[nodiscard]] std::vector<FourierRows> analyze_rows(const EquirectView& view, int first, int count,
                                                    int order);

}  // namespace nicol
