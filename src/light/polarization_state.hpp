// SPDX-License-Identifier: MIT
// Polarization of the light of a light source.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "polarization/stokes.hpp"

namespace nicol {

/// Polarization of a light source's light, equal in all directions. A polarizer in front of the source, which
/// absorbs along one axis whatever the direction of the light, is dolp = 1 and aolp = pi/2 with the absorbing
/// axis as `axis`. Mitsuba 3's `polarizer` is such a sheet with the axis (sin theta, cos theta, 0) of its
/// element. A quarter-wave plate behind the polarizer gives docp = 1 or -1.
struct PolarizationState {
    double dolp = 0;  ///< degree of linear polarization, 0 to 1
    /// Angle of linear polarization, radians, from the frame's x to its y, see polarization_frame().
    double aolp = 0;
    double docp = 0;  ///< s3 / s0: -1 to 1, positive is right circular; dolp^2 + docp^2 <= 1
    /// Direction of AoLP 0, in the light source's local axes, of any length but 0. Its component
    /// perpendicular to the direction of the light is used.
    glm::dvec3 axis{1, 0, 0};
    bool operator==(const PolarizationState&) const = default;

    [[nodiscard]] bool polarized() const noexcept { return dolp != 0 || docp != 0; }
    [[nodiscard]] bool circular() const noexcept { return docp != 0; }
    /// Returns the Stokes vector with s0 = 1 in polarization_frame().
    [[nodiscard]] Stokes stokes() const;
};

/// Throws Error(invalid_argument) that names the member that is out of range.
void check(const PolarizationState& state);

/// Returns the frame of light that travels along the unit direction `propagation`: z = propagation, x = the
/// component of `axis` perpendicular to it, both in the same axes. If the two are parallel, x is that of
/// theta_phi_frame().
[[nodiscard]] Frame polarization_frame(const glm::dvec3& axis, const glm::dvec3& propagation);

/// Returns the state's Stokes vector with s0 = 1, in a frame whose z is the light's propagation. `axis` is
/// the state's axis, transformed to the axes of the frame.
[[nodiscard]] Stokes stokes_in(const Frame& frame, const PolarizationState& state, const glm::dvec3& axis);

}  // namespace nicol
