// SPDX-License-Identifier: MIT
#include "polarization/fresnel.hpp"

#include <cmath>

namespace nicol {

Mueller fresnel_reflection(double cos_incident, std::complex<double> eta) {
    return mueller_of(reflection_block(cos_incident, RelativeIndex<double>(eta)));
}

Mueller fresnel_transmission(double cos_incident, double eta) {
    if (cos_incident <= 0) return {};
    double mean = 0;
    double difference = 0;
    dielectric_transmission(cos_incident, RelativeIndex<double>(eta), mean, difference);
    // The geometric mean of both polarizations' shares.
    const double c = std::sqrt((mean + difference) * (mean - difference));
    return Mueller({mean, difference, 0, 0, difference, mean, 0, 0, 0, 0, c, 0, 0, 0, 0, c});
}

}  // namespace nicol
