// SPDX-License-Identifier: MIT
// Reflection and refraction at a smooth interface.
#pragma once

#include <complex>

#include "polarization/mueller.hpp"

namespace nicol {

/// Amplitude coefficients of the parts perpendicular (s) and parallel (p) to the plane of incidence, in the
/// Verdet sign convention (at normal incidence p = -s). `eta` is the relative index n - ik of the far side.
struct FresnelAmplitudes {
    std::complex<double> s;
    std::complex<double> p;
};

/// cos_incident in [0, 1]. Total internal reflection gives coefficients of modulus one.
[[nodiscard]] FresnelAmplitudes fresnel_amplitudes(double cos_incident, std::complex<double> eta);

/// Mueller matrix of reflection; both frames have x along the s-axis, z along the propagation.
[[nodiscard]] Mueller fresnel_reflection(double cos_incident, std::complex<double> eta);

/// Mueller matrix of refraction into a dielectric of relative index eta > 0, power included (the factor
/// eta cos_t / cos_i); s-frames as above. Zero under total internal reflection. The way out at the refracted
/// angle has the same matrix.
[[nodiscard]] Mueller fresnel_transmission(double cos_incident, double eta);

}  // namespace nicol
