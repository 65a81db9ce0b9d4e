// SPDX-License-Identifier: MIT
// Conductors: rough and smooth metals.
#pragma once

#include <complex>
#include <numbers>
#include <string_view>
#include <vector>

#include "material/film.hpp"
#include "material/material.hpp"

namespace nicol {

/// Least absolute value of a complex index.
inline constexpr double kSmallestIndex = 1e-3;

/// Parameters of Mitsuba 3's `roughconductor`: single reflection off the facets of an opaque metal. k = 0
/// gives the reflection off the boundary of a dielectric.
struct RoughConductorParameters {
    /// Index n - ik relative to air, one value or one per channel. n and k lie in 0..100, and the absolute
    /// value is at least kSmallestIndex.
    std::vector<std::complex<double>> eta{{0.0, -1.0}};
    ColorParameter specular_reflectance{1.0};  ///< 0..1
    /// Roughness, 0.001..1, or 0 for a smooth surface (kSmoothAlpha). A texture is clamped to 0.01..1.
    NumberParameter alpha = 0.1;
    /// Roughness along y, in the range of alpha, which is then the roughness along x; 0: equal to alpha.
    /// Different values make the material anisotropic, and isotropic() then has their geometric mean.
    NumberParameter alpha_v = 0.0;
    Distribution distribution = Distribution::beckmann;
    /// Film on the facets, made for `eta`, as many channels as it has; null: none.
    FilmTablePtr film = nullptr;
};
/// Returns the material. Throws what pplastic() throws.
[[nodiscard]] MaterialPtr rough_conductor(const RoughConductorParameters& parameters);

/// Roughness of the Beckmann facets that replace a smooth surface, see Material::smooth(). The facets blur by
/// about one degree, less than order 100 resolves.
inline constexpr double kSmoothAlpha = 0.01;
/// Times the squared cosine of the view angle, the factor that makes the pBRDF of such facets in the mirror
/// direction Fresnel's matrix: without shadowing it is that matrix times D / (4 cos^2) with
/// D = 1 / (pi alpha^2).
inline constexpr double kMirrorScale = 4 * std::numbers::pi * kSmoothAlpha * kSmoothAlpha;

/// Returns whether alpha is 0, which means a smooth surface. If so, sets alpha to kSmoothAlpha and the
/// distribution to Beckmann.
inline bool take_smooth(double& alpha, Distribution& distribution) {
    if (alpha != 0) return false;
    alpha = kSmoothAlpha;
    distribution = Distribution::beckmann;
    return true;
}

/// Returns Mitsuba 3's `conductor`: rough_conductor() with alpha 0.
[[nodiscard]] MaterialPtr conductor(std::vector<std::complex<double>> eta,
                                    const ColorParameter& specular_reflectance = {1.0});

/// Returns the index n - ik of a metal for red, green and blue. n and k are converted like a spectrum of
/// light (rgb_emission_weights()) and are 0 outside the measured wavelengths, as in Mitsuba 3's modes without
/// spectra. The red value of a constant n is 1.2 n. metal_constants.hpp has the names and sources. Throws
/// Error(invalid_argument) for an unknown name.
[[nodiscard]] std::vector<std::complex<double>> metal_index(std::string_view metal);
/// Returns the index at wavelengths of 380 to 800 nm. Beyond the measurements, the nearest one holds.
[[nodiscard]] std::vector<std::complex<double>> metal_index(std::string_view metal,
                                                            const std::vector<double>& wavelengths);

}  // namespace nicol
