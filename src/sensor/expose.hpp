// SPDX-License-Identifier: MIT
// Raw images: what a sensor gives for a Stokes image.
#pragma once

#include <cstdint>
#include <vector>

#include "image/stokes_image.hpp"
#include "sensor/sensor.hpp"

namespace nicol {

/// Numbers of a sensor's pixels, values[y][x], row 0 at the top.
struct RawImage {
    int width = 0;
    int height = 0;
    std::vector<std::uint16_t> values;
};

/// Exposes the sensor to light in the image's frame (x right, y up). The result depends on the sensor, the
/// light and `frame` alone, to the last bit. Throws Error(invalid_argument) for a sensor or a size that
/// check() refuses, and for light that is not finite.
[[nodiscard]] RawImage expose(const Sensor& sensor, const StokesImage& light, std::uint64_t frame);

}  // namespace nicol
