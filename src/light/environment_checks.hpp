// SPDX-License-Identifier: MIT
// Checks that every kind of environment makes of its arguments.
#pragma once

#include <string>
#include <vector>

#include "nicol/environment.hpp"
#include "nicol/error.hpp"

namespace nicol {

/// Throws Error(invalid_argument) unless `channel` exists and `direction` is of unit length to 1e-6.
void check_look_up(const Environment& environment, int channel, const glm::dvec3& direction);

/// Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
void check_projection_order(int order);

/// Throws Error(invalid_argument) naming `what` unless there is a radiance and all are finite and >= 0.
void check_radiance(const char* what, const std::vector<double>& radiance);

/// Throws Error(invalid_argument) naming `what` unless there are no wavelengths or one finite value > 0 for
/// each of the channels.
void check_wavelengths(const char* what, const std::vector<double>& wavelengths, int channels);

/// Makes a picture physical up to what image_environment() tolerates, or throws Error(code) with `name` in
/// front of the channel and pixel.
void check_physical(StokesImage& image, const std::string& name, ErrorCode code);

/// Throws Error(invalid_argument) naming `what` unless scale is finite and >= 0.
void check_scale(const std::string& what, double scale);

/// image_environment() whose errors about the picture have this code and begin with `name`.
[[nodiscard]] EnvironmentPtr checked_environment(EquirectImage image, double scale, const std::string& name,
                                                 ErrorCode code);

}  // namespace nicol
