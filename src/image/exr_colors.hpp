// SPDX-License-Identifier: MIT
// Reading of colour images from OpenEXR files.
#pragma once

#include <filesystem>

#include "image/bitmap.hpp"

namespace nicol {

/// Reads R G B or Y, with A if present, of the first part. Other channels are ignored. Throws what read_exr()
/// throws.
[[nodiscard]] Bitmap read_exr_colors(const std::filesystem::path& file, const LoadBudget& budget = {});

}  // namespace nicol
