// SPDX-License-Identifier: MIT
// The step along the rows of a picture.
#pragma once

#include "light/equirect_projection.hpp"
#include "nicol/transform.hpp"

namespace nicol {

/// Fourier coefficients, over the azimuth of the propagation direction about the picture's axes, of one
/// channel's rows that are linear between pixels. Row i of the result lies at theta = i pi / (height - 1),
/// where i = 0 is the nadir of the picture (its last row), for theta belongs to where the light goes.
[[nodiscard]] FourierRows analyze_rows(const EquirectPixels& pixels, int channel, int order);

}  // namespace nicol
