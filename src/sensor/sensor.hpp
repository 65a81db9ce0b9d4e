// SPDX-License-Identifier: MIT
// Image sensors, with and without polarizers on their pixels.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "polarization/element.hpp"

namespace nicol {

/// Arrangement of polarizers and colour filters on a sensor's pixels. Angles are degrees counter-clockwise
/// from image right.
enum class Mosaic : std::uint32_t {
    plain,            ///< neither: each pixel measures the mean of all channels
    polarized,        ///< 90 45 / 135 0, as Sony's IMX250MZR; each pixel measures the mean of all channels
    polarized_bayer,  ///< the polarizers of `polarized`, each 2 x 2 under one of R G / G B: Sony's IMX250MYR
};

/// Linear sensor of the standard EMVA 1288. Light reaches it through a lens and `optics`. A pixel collects
///   n = Poisson(quantum_efficiency * exposure * I + dark_current * exposure_time)
/// electrons, at most full_well, where I is s0 behind the pixel's polarizer, and gives the number
///   floor(gain * (n + read_noise * normal + offset) + black_level + 1/2), cut to 0 .. 2^bits - 1.
/// The polarizers' errors, the offsets and the sensitivities belong to the pixel and the seed. The noise is
/// new in each frame.
struct Sensor {
    Mosaic mosaic = Mosaic::polarized;
    int bits = 12;                 ///< 8, 10, 12 or 16
    std::uint64_t seed = 0;        ///< seed of the noise and of the pixels' errors
    Mueller optics = unchanged();  ///< matrix of what stands in front of the sensor, in the image's frame
    /// Photons that reach a pixel with s0 = 1; 0: as many as fill the well with unpolarized light of s0 = 1.
    double exposure = 0;
    double exposure_time = 0.01;                  ///< seconds
    std::vector<double> quantum_efficiency{0.6};  ///< one value, or one per channel; above 0, at most 1
    double full_well = 10000;                     ///< electrons
    double gain = 0;               ///< numbers per electron; 0: the full well gives the largest number
    double black_level = 0;        ///< number without electrons
    bool shot_noise = true;        ///< whether electrons are Poisson distributed, or else their mean
    double read_noise = 2.5;       ///< standard deviation, electrons
    double dark_current = 0;       ///< electrons per second
    double dsnu = 0;               ///< standard deviation of the pixels' offsets, electrons
    double prnu = 0;               ///< relative standard deviation of the pixels' sensitivities
    double extinction_ratio = 0;   ///< transmittance along over across a polarizer's axis; 0: infinite
    double extinction_spread = 0;  ///< relative standard deviation of the transmittance across, over pixels
    double misalignment = 0;       ///< standard deviation of the polarizers' angles, degrees
    double crosstalk = 0;          ///< fraction of a pixel's electrons that go to its four neighbours
    double crosstalk_spread = 0;   ///< relative standard deviation of that fraction, over pixels
    double blur = 0;               ///< standard deviation of the lens's blur, pixels
    double vignetting = 0;         ///< part of the light that the lens loses in the image's corners

    /// Returns the identity, the matrix of no optics.
    [[nodiscard]] static Mueller unchanged() {
        return Mueller({1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
    }
};

/// Throws Error(invalid_argument) that names the member that is out of range.
void check(const Sensor& sensor);
/// Throws Error(invalid_argument) unless the sensor can be exposed to images of this size and number of
/// channels: whole cells of the mosaic, and three channels for colour filters.
void check(const Sensor& sensor, int width, int height, int channels);

/// Returns the pixels along a side of the mosaic's cell: 1, 2 or 4.
[[nodiscard]] int cell_side(Mosaic mosaic);

/// Returns the largest number of a pixel.
[[nodiscard]] double largest_number(const Sensor& sensor);
/// Returns the gain, resolved if automatic.
[[nodiscard]] double gain_of(const Sensor& sensor);
/// Returns electrons per unit of s0 behind a pixel's polarizer, for a channel; the exposure is resolved if
/// automatic.
[[nodiscard]] double electrons_of(const Sensor& sensor, std::size_t channel);

/// Index of a polarizer angle: 0, 45, 90 and 135 degrees.
[[nodiscard]] constexpr std::size_t angle_at(int x, int y) {
    constexpr std::array<std::size_t, 4> cell{2, 1, 3, 0};
    return cell[static_cast<std::size_t>(2 * (y & 1) + (x & 1))];
}
/// Index of the colour at a pixel of Mosaic::polarized_bayer: red, green, blue.
[[nodiscard]] constexpr std::size_t colour_at(int x, int y) {
    return static_cast<std::size_t>(((x >> 1) & 1) + ((y >> 1) & 1));
}

/// Returns the matrix of an element in the image's frame, facing the camera; to_world is not used.
/// extinction_ratio: transmittance along over across a polarizer's axis; 0: infinite. Throws
/// Error(invalid_argument) if an argument is out of range.
[[nodiscard]] Mueller in_front(const PolarizationElement& element, double extinction_ratio);

/// Sensors of data sheets.
enum class SensorPreset : std::uint32_t { imx250mzr, imx250myr };
/// Returns the sensor with the preset's mosaic, bits, full well and read noise.
[[nodiscard]] Sensor with_preset(Sensor sensor, SensorPreset preset);

}  // namespace nicol
