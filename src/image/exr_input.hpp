// SPDX-License-Identifier: MIT
// OpenEXR files opened with care.
#pragma once

#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "files/load_budget.hpp"

namespace nicol {

/// Calls read() with the file, whose structure has been checked. Throws Error(file_not_found), as
/// check_exr_structure(), and Error(invalid_file) where OpenEXR finds the file damaged.
void read_exr_input(const std::filesystem::path& file, const LoadBudget& budget,
                    const std::function<void(Imf::MultiPartInputFile& input)>& read);

/// Reads all rows of a part into its frame buffer, and asks `budget` in between.
void read_exr_rows(Imf::InputPart& part, const LoadBudget& budget);

/// Throws Error(invalid_file) naming channel and pixel, which is counted from the top left, unless the value
/// is finite.
void require_finite_pixel(const std::filesystem::path& file, const std::string& channel, std::size_t pixel,
                          int width, float value);

}  // namespace nicol
