// SPDX-License-Identifier: MIT
// Check of an OpenEXR file against its header, before memory is allocated for its pixels.
#pragma once

#include <cstdint>
#include <filesystem>
#include <istream>

#include "files/load_budget.hpp"

namespace nicol {

/// Throws Error(invalid_file) unless the file, which `in` reads from its beginning and has `file_size` bytes,
/// is well formed, its size in pixels is within kMaxImageSide and kMaxImagePixels, and every chunk of its
/// first part is present; Error(unsupported) if the first part is deep. Takes the memory of a decompressed
/// chunk from `budget`.
void check_exr_structure(const std::filesystem::path& file, std::istream& in, std::uintmax_t file_size,
                         const LoadBudget& budget);

}  // namespace nicol
