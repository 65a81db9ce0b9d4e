// SPDX-License-Identifier: MIT
// Statistics of a light.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "light/environment.hpp"

namespace nicol {

/// One colour channel. Means and fractions are over the sphere by solid angle, of image().
struct LightChannelReport {
    std::vector<Stokes> energy;  ///< energy_per_order() of the coefficients
    double smallest = 0;         ///< of s0
    double largest = 0;          ///< of s0
    double mean = 0;             ///< of s0
    double mean_dolp = 0;        ///< of sqrt(s1^2 + s2^2) / s0 where s0 > 0; each pixel weighted by its s0
    double largest_dolp = 0;     ///< of the same
    double circular = 0;         ///< largest |s3| / s0
    double negative = 0;         ///< fraction with s0 < 0
    double unphysical = 0;       ///< fraction that violates Eq. 70: sqrt(s1^2 + s2^2 + s3^2) > s0, or s0 < 0
    glm::dvec3 direction{0};     ///< mean of the directions light comes from, weighted by s0 > 0
    double largest_excess = 0;   ///< of sqrt(s1^2 + s2^2 + s3^2) - s0, over the mean of s0; 0 if none is > 0
};

struct LightReport {
    int width = 0;  ///< of image()
    int height = 0;
    bool polarized = false;
    bool circular = false;
    std::vector<double> wavelengths;  ///< nm, empty for colours
    std::vector<LightChannelReport> channels;
};

/// Of a light and its coefficients, up to any order; without coefficients, without energies. Rounding of
/// 32-bit floats is not counted as a violation: differences up to 1e-5 s0 are none.
[[nodiscard]] LightReport describe(const Environment& light, const PshVector& coefficients);

}  // namespace nicol
