// SPDX-License-Identifier: MIT
// Rows of a response table by quadrature.
#pragma once

#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "material/material.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Integrator for rows at any outgoing angle, term by term. Reuses its work space: not thread-safe.
/// Mueller matrices are evaluated sixteen at a time in single precision, and their sums over a circle of
/// azimuths are in single precision as well.
class RowIntegral {
public:
    /// Keeps references: both arguments must outlive the object.
    RowIntegral(const Material& material, const LightLayout& layout);

    /// Returns the rows [term][p][pairing][j] (see ResponseTable), with the material's pairings(), at a
    /// zenith angle in [0, pi/2). Valid until the next call.
    [[nodiscard]] std::span<const double> integrate(double theta_out);

private:
    struct AzimuthNode {
        float cos_phi;  // azimuth of the direction towards the light
        float sin_phi;
        float weight;
    };
    void place_azimuths(double narrow, double wide);
    void evaluate_circle(double theta, const glm::dvec3& viewer);
    void take_moments();
    [[nodiscard]] bool has_spin() const;  // whether the circle's matrices have a column of s1 or s2
    void accumulate(double solid_angle);

    const Material& material_;
    const LightLayout& layout_;
    std::size_t terms_;
    std::size_t pairings_;
    std::size_t columns_;  // of the Mueller matrices
    std::size_t blocks_;   // sixteens that order + 1 waves fill
    double lobe_;          // smallest lobe width of all terms
    std::vector<AzimuthNode> azimuths_;
    std::vector<Lanes> cosines_, sines_;  // [node][block] of m phi_p; azimuth of propagation phi_p = phi + pi
    std::vector<LaneMueller> muellers_;   // [term]
    std::vector<float> values_;           // [term][p][q][node], times the node's weight
    std::vector<bool> empty_;             // [term][p][q]: whether all values are 0
    std::vector<Lanes> moments_;          // [term][p][q][pairing][block]
    std::vector<double> scalar_, spin2_;  // harmonics by psh_index
    std::vector<double> first_, second_;  // zenith_functions()
    std::vector<double> rows_;            // [term][p][pairing][j]
};

}  // namespace nicol
