// SPDX-License-Identifier: MIT
// Rows of a response table by quadrature.
#pragma once

#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "material/material.hpp"

namespace nicol {

/// Integrator for rows at any outgoing angle, term by term. Reuses its work space: not thread-safe.
class RowIntegral {
public:
    /// Keeps references: both arguments must outlive the object.
    RowIntegral(const Material& material, const LightLayout& layout);

    /// Returns the rows [term][p][pairing][j] (see ResponseTable), with the material's pairings(), at a
    /// zenith angle in [0, pi/2). Valid until the next call.
    [[nodiscard]] std::span<const double> integrate(double theta_out);

private:
    struct AzimuthNode {
        double cos_phi;  // azimuth of the direction towards the light
        double sin_phi;
        double weight;
    };
    void place_azimuths(double narrow, double wide);
    void add_terms(double theta_out, std::span<const int> terms);
    void take_moments(double theta, const glm::dvec3& viewer, std::span<const int> terms);
    void accumulate(double solid_angle, std::span<const int> terms);

    const Material& material_;
    const LightLayout& layout_;
    std::size_t pairings_;
    std::size_t waves_;  // order + 1
    std::vector<std::vector<int>> groups_;
    std::vector<AzimuthNode> azimuths_;
    std::vector<double> cosines_, sines_;  // [node][m] of m phi_p; azimuth of propagation phi_p = phi + pi
    std::vector<Mueller> muellers_;        // [term]
    std::vector<double> moments_;          // [term in group][p][q][pairing][m]
    std::vector<double> scalar_, spin2_;   // harmonics by psh_index
    std::vector<double> first_, second_;   // zenith_functions()
    std::vector<double> rows_;             // [term][p][pairing][j]
};

}  // namespace nicol
