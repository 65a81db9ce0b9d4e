// SPDX-License-Identifier: MIT
// Checks of arguments that all environments share.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "error.hpp"
#include "light/environment.hpp"

namespace nicol {

/// Throws Error(invalid_argument) unless `channel` exists and `direction` is of unit length to 1e-6.
void check_look_up(const Environment& environment, int channel, const glm::dvec3& direction);

/// Throws Error(invalid_argument) unless 0 <= order <= kMaxOrder.
void check_projection_order(int order);

/// Throws Error(invalid_argument) that names `what` unless there is a radiance and all are finite and >= 0.
void check_radiance(const char* what, const std::vector<double>& radiance);

/// Throws Error(invalid_argument) that names `what` unless there are no wavelengths or one finite value > 0
/// for each of the channels.
void check_wavelengths(const char* what, const std::vector<double>& wavelengths, int channels);

/// Content of an image that is physically realizable.
struct ImageContents {
    bool linear = false;    ///< some s1 or s2 is not 0
    bool circular = false;  ///< some s3 is not 0
    /// Sum of s0 < 0, which will be set to 0, divided by the sum of s0 > 0; the largest of all channels.
    double negative = 0;
};

/// Checks the pixels times `scale`. Throws Error(code) whose message has `name`, channel and pixel if
/// image_environment() would refuse the pixels. row_weights: the solid angles of the rows' pixels up to a
/// factor.
[[nodiscard]] ImageContents examine_image(const EquirectView& view, double scale,
                                          std::span<const double> row_weights, const std::string& name,
                                          ErrorCode code);

/// Checks an equirectangular image, which must have at least 2 x 2 pixels, as examine_image() does.
[[nodiscard]] ImageContents examine_equirect(const EquirectView& view, double scale, const std::string& name,
                                             ErrorCode code);

/// Throws Error(invalid_argument) that names `what` unless scale is finite and >= 0.
void check_scale(const std::string& what, double scale);

/// Returns a view of a whole image.
[[nodiscard]] EquirectView view_of(const StokesImage& image);

/// Returns image_environment() of the view. Its errors about the image have this code and begin with `name`.
/// `negative` is the negative share of the image from which `view` was made.
[[nodiscard]] EnvironmentPtr checked_environment(const EquirectView& view, std::vector<double> wavelengths,
                                                 double scale, const std::string& name, ErrorCode code,
                                                 double negative = 0);

}  // namespace nicol
