// SPDX-License-Identifier: MIT
// Visibility as harmonics by definition, in double precision.
#pragma once

#include "harmonics/scalar_harmonics.hpp"
#include "polarization/stokes.hpp"
#include "visibility/visibility.hpp"
#include "visibility/visibility_directions.hpp"

namespace nicol::test {

/// Returns coefficients of a vertex's mirrored visibility over real harmonics, [psh_index(l, m)]. Visible
/// directions count 1 and others 0. The visible part is exact in order 0.
inline std::vector<double> visibility_in_double(const Visibility& visibility, std::size_t vertex,
                                                const glm::vec3& normal, const DirectionSet& directions,
                                                int order) {
    std::vector<double> out(psh_count(order));
    out[0] = std::sqrt(4 * std::numbers::pi);
    if (visibility.unoccluded(vertex)) return out;
    const glm::dvec3 n = glm::normalize(glm::dvec3(normal));
    const Frame frame = theta_phi_frame(n);
    double seen = 0;
    double all = 0;
    std::vector<std::size_t> above;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        if (glm::dot(glm::dvec3(directions.directions()[i]), n) <= 0) continue;
        above.push_back(i);
        const double weight = static_cast<double>(directions.weights()[i]);
        all += weight;
        if (visibility.seen(vertex, i)) seen += weight;
    }
    const double fraction = all > 0 ? seen / all : 0;
    out[0] *= fraction;
    for (const std::size_t i : above) {
        const auto y = scalar_harmonics(order, -(glm::dvec3(directions.directions()[i]) * frame));
        const double weight = static_cast<double>(directions.weights()[i]) *
                              (visibility.seen(vertex, i) ? 1 - fraction : -fraction);
        for (int l = 0; l <= order; ++l)
            for (int m = -l; m <= l; ++m)
                if ((l + m) % 2 == 0) out[psh_index(l, m)] += 2 * weight * y[psh_index(l, m)];
    }
    return out;
}

}  // namespace nicol::test
