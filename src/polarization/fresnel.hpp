// SPDX-License-Identifier: MIT
// Mueller matrices of reflection and refraction at a smooth interface.
#pragma once

#include <complex>

#include "polarization/mueller.hpp"

namespace nicol {

/// Amplitude coefficients of the components perpendicular (s) and parallel (p) to the plane of incidence, in
/// the Verdet sign convention (at normal incidence p = -s). `eta` is the relative index n - ik of the far
/// side.
struct FresnelAmplitudes {
    std::complex<double> s;
    std::complex<double> p;
};

/// Returns the amplitude coefficients for cos_incident in [0, 1]. Total internal reflection gives
/// coefficients of modulus one.
[[nodiscard]] FresnelAmplitudes fresnel_amplitudes(double cos_incident, std::complex<double> eta);

/// Returns the Mueller matrix of reflection. Both frames have x along the s-axis and z along the propagation.
[[nodiscard]] Mueller fresnel_reflection(double cos_incident, std::complex<double> eta);

/// Returns the Mueller matrix of refraction into a dielectric of relative index eta > 0. The matrix includes
/// the power factor eta cos_t / cos_i. Both frames have x along the s-axis and z along the propagation. The
/// matrix is zero under total internal reflection. Refraction in the reverse direction at the refracted angle
/// has an equal matrix.
[[nodiscard]] Mueller fresnel_transmission(double cos_incident, double eta);

}  // namespace nicol
