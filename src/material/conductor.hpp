// SPDX-License-Identifier: MIT
// Metals.
#pragma once

#include <complex>
#include <string_view>
#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Least length of an index.
inline constexpr double kSmallestIndex = 1e-3;

/// Mitsuba 3's `roughconductor`: single reflection off the facets of an opaque metal. With k = 0 what the
/// boundary of a dielectric reflects.
struct RoughConductorParameters {
    /// Index n - ik relative to air, one value or one a channel: n and k in 0..100, at least
    /// kSmallestIndex long.
    std::vector<std::complex<double>> eta{{0.0, -1.0}};
    ColorParameter specular_reflectance{1.0};  ///< 0..1
    /// Roughness, 0.001..1; 0: smooth, kSmoothAlpha stands for it. A texture is moved to 0.01..1.
    NumberParameter alpha = 0.1;
    /// Roughness along y where alpha is that along x, in the same range; 0: as alpha. One that differs makes
    /// the material anisotropic; its isotropic() counterpart has the geometric mean of both.
    NumberParameter alpha_v = 0.0;
    Distribution distribution = Distribution::beckmann;
};
/// Throws as pplastic().
[[nodiscard]] MaterialPtr rough_conductor(const RoughConductorParameters& parameters);

/// Roughness of Beckmann's facets that stand for a smooth surface, see Material::smooth(). They blur by about
/// one degree, less than order 100 resolves.
inline constexpr double kSmoothAlpha = 0.01;

/// Whether alpha is 0, a smooth surface; if so, becomes what stands for it: Beckmann's facets of
/// kSmoothAlpha.
inline bool take_smooth(double& alpha, Distribution& distribution) {
    if (alpha != 0) return false;
    alpha = kSmoothAlpha;
    distribution = Distribution::beckmann;
    return true;
}

/// Mitsuba 3's `conductor`: rough_conductor() of alpha 0.
[[nodiscard]] MaterialPtr conductor(std::vector<std::complex<double>> eta,
                                    const ColorParameter& specular_reflectance = {1.0});

/// Index n - ik of a metal for red, green and blue: n and k are each the colour of light of that spectrum
/// (rgb_emission_weights()), 0 where it was not measured, as in Mitsuba 3's modes without spectra. The red of
/// a constant n is then 1.2 n. Names and sources: metal_constants.hpp. Throws Error(invalid_argument) for
/// others.
[[nodiscard]] std::vector<std::complex<double>> metal_index(std::string_view metal);
/// The same at wavelengths in nm, 380 to 800; where it was not measured that of the nearest one that was.
[[nodiscard]] std::vector<std::complex<double>> metal_index(std::string_view metal,
                                                            const std::vector<double>& wavelengths);

}  // namespace nicol
