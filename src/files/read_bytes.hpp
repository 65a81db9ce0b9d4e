// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "files/load_budget.hpp"

namespace nicol {

/// Returns the content of a whole file. Throws Error(file_not_found) unless `file` is a regular file that can
/// be read. `budget` is checked during reading.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file, const LoadBudget& budget = {});

}  // namespace nicol
