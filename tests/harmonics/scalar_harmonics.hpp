// SPDX-License-Identifier: MIT
// Real spherical harmonics of scalar functions.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "harmonics/evaluate.hpp"
#include "harmonics/grid.hpp"
#include "harmonics/psh.hpp"

namespace nicol::test {

/// Returns the harmonics at a direction, [psh_index(l, m)].
inline std::vector<double> scalar_harmonics(int order, const glm::dvec3& direction) {
    std::vector<double> out(psh_count(order));
    std::vector<std::complex<double>> spin2(out.size());
    harmonics_at(order, direction, out, spin2);
    return out;
}

/// Returns the coefficients of a function of the direction.
template <class Function>
std::vector<double> project_scalar(int order, const Function& f) {
    const LatitudeRows rows = gauss_legendre_rows(128);
    constexpr int columns = 256;
    std::vector<double> out(psh_count(order));
    for (std::size_t j = 0; j < rows.theta.size(); ++j) {
        const double sine = std::sin(rows.theta[j]);
        for (int k = 0; k < columns; ++k) {
            const double phi = 2 * std::numbers::pi * (k + 0.5) / columns;
            const glm::dvec3 d(sine * std::cos(phi), sine * std::sin(phi), std::cos(rows.theta[j]));
            const double value = f(d) * rows.weight[j] * 2 * std::numbers::pi / columns;
            const std::vector<double> y = scalar_harmonics(order, d);
            for (std::size_t i = 0; i < y.size(); ++i) out[i] += value * y[i];
        }
    }
    return out;
}

}  // namespace nicol::test
