// SPDX-License-Identifier: MIT
#include "polarization/fresnel.hpp"

#include <cmath>

namespace nicol {

FresnelAmplitudes fresnel_amplitudes(double cos_incident, std::complex<double> eta) {
    const double sin2 = 1 - cos_incident * cos_incident;
    const std::complex<double> eta2 = eta * eta;
    std::complex<double> q = std::sqrt(eta2 - sin2);  // eta cos_t
    // With indices n - ik a decaying wave has a negative imaginary part; sqrt of a negative real has a
    // positive one.
    if (q.imag() > 0) q = std::conj(q);
    return {(cos_incident - q) / (cos_incident + q), (eta2 * cos_incident - q) / (eta2 * cos_incident + q)};
}

Mueller fresnel_reflection(double cos_incident, std::complex<double> eta) {
    const FresnelAmplitudes r = fresnel_amplitudes(cos_incident, eta);
    const double sum = (std::norm(r.s) + std::norm(r.p)) / 2;
    const double difference = (std::norm(r.s) - std::norm(r.p)) / 2;
    // |r_s r_p| e^{id} with d = arg r_p - arg r_s. The product carries the sign change at Brewster's angle.
    const std::complex<double> c = r.p * std::conj(r.s);
    return Mueller(
        {sum, difference, 0, 0, difference, sum, 0, 0, 0, 0, c.real(), -c.imag(), 0, 0, c.imag(), c.real()});
}

Mueller fresnel_transmission(double cos_incident, double eta) {
    const double q2 = eta * eta - 1 + cos_incident * cos_incident;
    if (q2 <= 0 || cos_incident <= 0) return {};
    const double q = std::sqrt(q2);
    const double amplitude_s = 2 * cos_incident / (cos_incident + q);
    const double amplitude_p = 2 * eta * cos_incident / (eta * eta * cos_incident + q);
    const double power = q / cos_incident;
    const double s = power * amplitude_s * amplitude_s;
    const double p = power * amplitude_p * amplitude_p;
    const double c = power * amplitude_s * amplitude_p;
    return Mueller({(s + p) / 2, (s - p) / 2, 0, 0, (s - p) / 2, (s + p) / 2, 0, 0, 0, 0, c, 0, 0, 0, 0, c});
}

}  // namespace nicol
