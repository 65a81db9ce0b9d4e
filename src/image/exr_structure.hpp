// SPDX-License-Identifier: MIT
// Whether an OpenEXR file is what its header says, before its pixels are given memory.
#pragma once

#include <cstdint>
#include <filesystem>

#include "files/load_budget.hpp"

namespace nicol {

/// Throws Error(invalid_file) unless the file, of `file_size` bytes, is well formed, its size in pixels is
/// within kMaxImageSide and kMaxImagePixels, and every chunk of its first part is there; Error(unsupported)
/// if that part is deep. Takes the memory of a decompressed chunk from `budget`.
void check_exr_structure(const std::filesystem::path& file, std::uintmax_t file_size,
                         const LoadBudget& budget);

}  // namespace nicol
