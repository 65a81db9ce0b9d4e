// SPDX-License-Identifier: MIT
// Weights that turn values at measured wavelengths into colour channels.
#pragma once

#include <span>
#include <vector>

namespace nicol {

/// Weights of channel = sum_k weights[channel][k] value[k]. For reflectances the weights of a channel sum to
/// 1, so that grey stays grey.
using ChannelWeights = std::vector<std::vector<double>>;

/// Returns the weights for linear red, green and blue with the primaries and the white point (D65) of BT.709
/// and sRGB. The reflectance is linear between the wavelengths and constant beyond them. The observer is CIE
/// 1931 under D65, in tables of 10 nm from 380 to 780. Weights may be negative, because saturated spectra lie
/// outside the gamut. `wavelengths`: nm, increasing, at least one; else throws Error(invalid_argument).
[[nodiscard]] ChannelWeights rgb_weights(std::span<const double> wavelengths);

/// Returns the weights for linear red, green and blue of an emission, scaled to the luminance: weights of the
/// CIE 1931 observer, divided by the integral of its y. A constant emission becomes white of equal energy,
/// (1.205, 0.948, 0.909), not (1, 1, 1).
[[nodiscard]] ChannelWeights rgb_emission_weights(std::span<const double> wavelengths);

/// Returns one channel per requested wavelength: linear between measured wavelengths, constant beyond them.
[[nodiscard]] ChannelWeights linear_weights(std::span<const double> wavelengths,
                                            std::span<const double> requested);

/// Returns one channel per requested wavelength: the nearest measured one, the shorter of two equally near.
[[nodiscard]] ChannelWeights nearest_weights(std::span<const double> wavelengths,
                                             std::span<const double> requested);

}  // namespace nicol
