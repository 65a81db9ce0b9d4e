// SPDX-License-Identifier: MIT
// Stokes images of what polarizers at four angles let pass.
#pragma once

#include "image/stokes_image.hpp"
#include "sensor/expose.hpp"

namespace nicol {

enum class Demosaic : std::uint32_t {
    bilinear,  ///< the mosaic's size; each angle and colour is interpolated between its pixels
    blocks,    ///< one Stokes vector per cell of the mosaic, from the cell's pixels alone
    gradient,  ///< the mosaic's size; angles are interpolated along edges, by the gradients across
};

/// Returns the light on the sensor, behind its optics: the inverse of expose() without noise, for pixels
/// without errors of their own and without crosstalk. s3 is 0; Mosaic::plain gives s0 alone. Throws
/// Error(invalid_argument) for a sensor or size that check() refuses.
[[nodiscard]] StokesImage demosaic(const Sensor& sensor, const RawImage& raw, Demosaic method);

/// Returns the Stokes vector of intensities behind polarizers at 0, 45, 90 and 135 degrees that transmit
/// `across` of the light across their axes, as a fraction of the light along their axes.
[[nodiscard]] std::array<float, 4> stokes_of_angles(const std::array<double, 4>& intensities, double across);

}  // namespace nicol
