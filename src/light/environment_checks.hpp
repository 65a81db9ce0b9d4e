// SPDX-License-Identifier: MIT
// Checks that every kind of environment makes of its arguments.
#pragma once

#include <vector>

#include "nicol/environment.hpp"

namespace nicol {

/// Throws Error(invalid_argument) unless `channel` exists and `direction` is of unit length to 1e-6.
void check_look_up(const Environment& environment, int channel, const glm::dvec3& direction);

/// Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
void check_projection_order(int order);

/// Throws Error(invalid_argument) naming `what` unless there is a radiance and all are finite and >= 0.
void check_radiance(const char* what, const std::vector<double>& radiance);

}  // namespace nicol
