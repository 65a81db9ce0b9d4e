// SPDX-License-Identifier: MIT
// How the light of a light source is polarized.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "polarization/stokes.hpp"

namespace nicol {

/// The same for all light of a light source. A polarizing sheet in front of it, which absorbs along one axis
/// however light passes it, is dolp = 1 and aolp = pi/2 with that as `axis`; so is Mitsuba 3's `polarizer`,
/// whose axis is (sin theta, cos theta, 0) of its element. A quarter-wave plate behind that: docp = 1 or -1.
struct PolarizationState {
    double dolp = 0;  ///< degree of linear polarization, 0 to 1
    /// Angle of linear polarization, radians, from the frame's x to its y, see polarization_frame().
    double aolp = 0;
    double docp = 0;  ///< s3 / s0: -1 to 1, positive is right circular; dolp^2 + docp^2 <= 1
    /// Where AoLP is 0, in the light source's own axes, of any length but 0: its part across the direction of
    /// the light.
    glm::dvec3 axis{1, 0, 0};
    bool operator==(const PolarizationState&) const = default;

    [[nodiscard]] bool polarized() const noexcept { return dolp != 0 || docp != 0; }
    [[nodiscard]] bool circular() const noexcept { return docp != 0; }
    /// Of s0 = 1, in polarization_frame().
    [[nodiscard]] Stokes stokes() const;
};

/// Throws Error(invalid_argument) naming the member that is out of range.
void check(const PolarizationState& state);

/// The frame of light that travels along the unit direction `propagation`: z = propagation, x = the part of
/// `axis` across it, both in the same axes. Where they are parallel, x is that of theta_phi_frame().
[[nodiscard]] Frame polarization_frame(const glm::dvec3& axis, const glm::dvec3& propagation);

/// The state's Stokes vector, of s0 = 1, in a frame whose z is the light's propagation; `axis` is the
/// state's, brought into the axes of that frame.
[[nodiscard]] Stokes stokes_in(const Frame& frame, const PolarizationState& state, const glm::dvec3& axis);

}  // namespace nicol
