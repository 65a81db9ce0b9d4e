// SPDX-License-Identifier: MIT
// How much light passes the boundary of a dielectric.
#pragma once

#include <vector>

#include "material/material.hpp"

namespace nicol {

/// Of unpolarized light, without what facets pass on to each other, as Mitsuba 3's `plastic` and
/// `roughplastic` have it. `eta` is the index of the inside over that of the outside. Immutable.
class BoundaryTransmittance {
public:
    /// Of a smooth boundary: Fresnel's formulas.
    explicit BoundaryTransmittance(double eta);
    /// Of a rough one: tabulated over the cosine, linear in between.
    BoundaryTransmittance(double eta, Distribution distribution, double alpha);

    /// The share of light from outside that passes, at an angle given by its cosine, above 0 to 1.
    [[nodiscard]] double at(double cosine) const;
    /// The same of sixteen cosines, in single precision; of those that are not above 0, anything.
    void at_lanes(const Lanes& cosines, Lanes& out) const;
    /// The share of diffuse light from inside that is reflected back.
    [[nodiscard]] double returned() const noexcept { return returned_; }

private:
    [[nodiscard]] float tabulated(float cosine) const;

    double eta_;
    double returned_;
    std::vector<float> table_;  ///< at evenly spaced cosines of 0 to 1; empty of a smooth boundary
};

}  // namespace nicol
