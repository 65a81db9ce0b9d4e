// SPDX-License-Identifier: MIT
// Statistics of the radiance and polarization of a light.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "light/environment.hpp"

namespace nicol {

/// Report of one colour channel. Means and fractions are taken over the pixels of image(), weighted by solid
/// angle.
struct LightChannelReport {
    std::vector<Stokes> energy;  ///< energy_per_order() of the coefficients
    double smallest = 0;         ///< smallest s0
    double largest = 0;          ///< largest s0
    double mean = 0;             ///< mean s0
    double mean_dolp = 0;     ///< mean of sqrt(s1^2 + s2^2) / s0 where s0 > 0, each pixel weighted by its s0
    double largest_dolp = 0;  ///< largest sqrt(s1^2 + s2^2) / s0
    double circular = 0;      ///< largest |s3| / s0
    double negative = 0;      ///< fraction with s0 < 0
    double unphysical = 0;    ///< fraction that violates Eq. 70: sqrt(s1^2 + s2^2 + s3^2) > s0, or s0 < 0
    glm::dvec3 direction{0};  ///< mean direction towards the light, weighted by s0 where s0 > 0
    /// Largest sqrt(s1^2 + s2^2 + s3^2) - s0, divided by the mean s0; 0 if none is > 0.
    double largest_excess = 0;
};

struct LightReport {
    int width = 0;  ///< columns of image()
    int height = 0;
    bool polarized = false;
    bool circular = false;
    std::vector<double> wavelengths;  ///< nm, empty for colours
    std::vector<LightChannelReport> channels;
};

/// Returns the report of a light and its coefficients, which may have any order. Empty coefficients give no
/// energies. Differences up to 1e-5 s0 are not violations, because they come from rounding to 32-bit floats.
[[nodiscard]] LightReport describe(const Environment& light, const PshVector& coefficients);

}  // namespace nicol
