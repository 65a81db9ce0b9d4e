// SPDX-License-Identifier: MIT
// Pictures behind a polarizer at four angles.
#pragma once

#include <array>
#include <filesystem>

#include "image/stokes_image.hpp"

namespace nicol {

/// Reads pictures of one view behind a polarizer at 0, 45, 90 and 135 degrees (counter-clockwise from image
/// right), and returns the Stokes image in front of it, with s3 = 0. EXR files give s0, other images their
/// numbers as they are, as linear light in 0 to 1. Throws what the readers throw, and Error(invalid_file) if
/// the pictures differ in size or channels.
[[nodiscard]] StokesImage read_angle_pictures(const std::array<std::filesystem::path, 4>& files);

}  // namespace nicol
