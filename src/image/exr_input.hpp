// SPDX-License-Identifier: MIT
// Checked opening and reading of OpenEXR files.
#pragma once

#include <ImfInputPart.h>
#include <ImfMultiPartInputFile.h>

#include <cstddef>
#include <filesystem>
#include <functional>
#include <string>

#include "files/load_budget.hpp"

namespace nicol {

/// Calls read() with the opened file after checking the file's structure. Throws Error(file_not_found), what
/// check_exr_structure() throws, and Error(invalid_file) if OpenEXR finds the file damaged.
void read_exr_input(const std::filesystem::path& file, const LoadBudget& budget,
                    const std::function<void(Imf::MultiPartInputFile& input)>& read);

/// Reads all rows of a part into its frame buffer and checks `budget` in between.
void read_exr_rows(Imf::InputPart& part, const LoadBudget& budget);

/// Throws Error(invalid_file) that names channel and pixel, counted from the top left, unless the value is
/// finite.
void require_finite_pixel(const std::filesystem::path& file, const std::string& channel, std::size_t pixel,
                          int width, float value);

}  // namespace nicol
