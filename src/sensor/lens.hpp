// SPDX-License-Identifier: MIT
// Blur and vignetting of a lens.
#pragma once

#include "image/stokes_image.hpp"
#include "sensor/sensor.hpp"

namespace nicol {

/// Returns the light behind the sensor's lens, with the same bits on every machine: blurred by a normal
/// distribution of standard deviation `blur` (cut at four of them, the border's pixels repeated), then
/// multiplied by the fourth power of the cosine of the angle from the optical axis, which leaves 1 -
/// vignetting in the image's corners.
[[nodiscard]] StokesImage through_lens(const Sensor& sensor, const StokesImage& light);

}  // namespace nicol
