// SPDX-License-Identifier: MIT
// Colour images from OpenEXR.
#pragma once

#include <filesystem>

#include "image/bitmap.hpp"

namespace nicol {

/// R G B or Y, with A if there is one, of the first part; other channels are ignored. Throws as read_exr().
[[nodiscard]] Bitmap read_exr_colors(const std::filesystem::path& file, const LoadBudget& budget = {});

}  // namespace nicol
