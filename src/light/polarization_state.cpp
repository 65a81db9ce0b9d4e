// SPDX-License-Identifier: MIT
#include "light/polarization_state.hpp"

#include <cmath>
#include <string>

#include "arguments.hpp"

namespace nicol {

Stokes PolarizationState::stokes() const {
    return {1, dolp * std::cos(2 * aolp), dolp * std::sin(2 * aolp), docp};
}

void check(const PolarizationState& state) {
    if (!(state.dolp >= 0 && state.dolp <= 1))
        refuse("dolp is " + std::to_string(state.dolp) + "; it must lie in 0 to 1");
    if (!(state.docp >= -1 && state.docp <= 1))
        refuse("docp is " + std::to_string(state.docp) + "; it must lie in -1 to 1");
    constexpr double rounding = 1e-6;
    if (state.dolp * state.dolp + state.docp * state.docp > 1 + rounding) {
        refuse("dolp is " + std::to_string(state.dolp) + " and docp " + std::to_string(state.docp) +
               ": more polarized than light; the sum of their squares must be at most 1");
    }
    if (!std::isfinite(state.aolp)) refuse("aolp is not finite; it is an angle in radians");
    const double length = glm::length(state.axis);
    if (!(length > 0 && std::isfinite(length))) refuse("axis has no direction; it is where the AoLP is 0");
}

Frame polarization_frame(const glm::dvec3& axis, const glm::dvec3& propagation) {
    const glm::dvec3 across = axis - glm::dot(axis, propagation) * propagation;
    constexpr double parallel = 1e-9;
    if (glm::length(across) <= parallel * glm::length(axis)) return theta_phi_frame(propagation);
    return frame_with_x(propagation, across);
}

Stokes stokes_in(const Frame& frame, const PolarizationState& state, const glm::dvec3& axis) {
    if (state.dolp == 0) return state.stokes();
    return rotated(state.stokes(), angle_between(polarization_frame(axis, frame[2]), frame));
}

}  // namespace nicol
