// SPDX-License-Identifier: MIT
#include "polarization/slab.hpp"

#include "polarization/fresnel.hpp"

namespace nicol {

SlabSplit slab_split(double cos_incident, double eta) {
    const Mueller once = fresnel_reflection(cos_incident, eta);
    // Under total reflection, no light enters the slab.
    if (!(fresnel_transmission(cos_incident, eta)(0, 0) > 0)) return {.reflection = once, .transmission = {}};
    // Both sides reflect the shares s, p and their correlation c, because the amplitudes differ only in sign.
    // The slab reflects r + t (r + r^3 + ...) t and transmits t (1 + r^2 + ...) t, with t^2 = 1 - r for s and
    // p, and t^2 = (1 - s)(1 - p) for the correlation.
    const double s = once(0, 0) + once(0, 1);
    const double p = once(0, 0) - once(0, 1);
    const double c = once(2, 2);
    const double s_out = (1 - s) / (1 + s);
    const double p_out = (1 - p) / (1 + p);
    const double c_out = (1 - s) * (1 - p) / (1 - c * c);
    const auto block = [](double of_s, double of_p, double correlation) {
        const double mean = (of_s + of_p) / 2;
        const double difference = (of_s - of_p) / 2;
        return Mueller(
            {mean, difference, 0, 0, difference, mean, 0, 0, 0, 0, correlation, 0, 0, 0, 0, correlation});
    };
    return {.reflection = block(2 * s / (1 + s), 2 * p / (1 + p), c + c * c_out),
            .transmission = block(s_out, p_out, c_out)};
}

}  // namespace nicol
