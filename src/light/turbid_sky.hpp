// SPDX-License-Identifier: MIT
// Clear sky with haze by Perez's formula with the coefficients of Preetham et al. (1999).
#pragma once

#include <array>

#include "light/environment.hpp"

namespace nicol {

/// Sky of a turbidity (1.7 clear to 10 hazy) and an angle of the sun from the zenith (0..pi/2).
class PerezSky {
public:
    PerezSky(double turbidity, double sun_zenith);

    /// Returns luminance (in kcd/m^2) and CIE chromaticity {Y, x, y} at a cosine > 0 of the zenith angle and
    /// an angle `gamma` from the sun.
    [[nodiscard]] std::array<double, 3> at(double cos_zenith, double gamma) const;

private:
    using Coefficients = std::array<double, 5>;

    std::array<Coefficients, 3> shape_;  // coefficients of Y, x, y
    std::array<double, 3> factor_;       // value at the zenith over the shape's value there
};

/// Returns the factor that takes a luminance of at(), kcd/m^2, to that of a sky whose mean over the upper
/// half is 1.
[[nodiscard]] double scale_to_mean_one(const PerezSky& perez, const glm::dvec3& sun);

/// Returns the linear sRGB of a luminance and chromaticity, which may be negative outside the gamut.
[[nodiscard]] std::array<double, 3> linear_srgb(const std::array<double, 3>& luminance_x_y);

/// Returns the image for a unit vector `sun` that is not below the horizon and members of `sky` that are in
/// range, turbidity > 0.
[[nodiscard]] EquirectImage turbid_sky_image(const RayleighSky& sky, const glm::dvec3& sun);

}  // namespace nicol
