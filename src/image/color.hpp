// SPDX-License-Identifier: MIT
// Colours of BT.709 and sRGB, white point D65.
#pragma once

#include <array>
#include <cmath>

namespace nicol {

/// Converts CIE XYZ to linear red, green and blue, which may be negative outside the gamut.
[[nodiscard]] constexpr std::array<double, 3> linear_rgb(double x, double y, double z) {
    return {3.2404542 * x - 1.5371385 * y - 0.4985314 * z, -0.9692660 * x + 1.8760108 * y + 0.0415560 * z,
            0.0556434 * x - 0.2040259 * y + 1.0572252 * z};
}

/// Decodes the curve of sRGB (IEC 61966-2-1) for 0 to 1.
[[nodiscard]] inline float srgb_to_linear(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// Weights of linear red, green and blue in luminance.
inline constexpr std::array<float, 3> kLuminance{0.2126F, 0.7152F, 0.0722F};

}  // namespace nicol
