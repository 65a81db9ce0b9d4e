// SPDX-License-Identifier: MIT
// Transmittance of a dielectric boundary.
#pragma once

#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Transmittance for unpolarized light without multiple scattering between facets, as in Mitsuba 3's
/// `plastic` and `roughplastic`. `eta` is the index of the inside over the index of the outside. Immutable.
class BoundaryTransmittance {
public:
    /// Makes a smooth boundary, which follows Fresnel's formulas.
    explicit BoundaryTransmittance(double eta);
    /// Makes a rough boundary: a table over the cosine, linear between its entries.
    BoundaryTransmittance(double eta, Distribution distribution, double alpha);

    /// Returns the share of light from outside that passes at an angle given by its cosine, above 0 to 1.
    [[nodiscard]] double at(double cosine) const;
    /// Computes at() of sixteen cosines in single precision; the result is unspecified for cosines up to 0.
    void at_lanes(const Lanes& cosines, Lanes& out) const;
    /// Returns the share of diffuse light from inside that the boundary reflects back.
    [[nodiscard]] double returned() const noexcept { return returned_; }

private:
    [[nodiscard]] float tabulated(float cosine) const;

    double eta_;
    double returned_;
    std::vector<float> table_;  ///< values at evenly spaced cosines of 0 to 1; empty for a smooth boundary
};

}  // namespace nicol
