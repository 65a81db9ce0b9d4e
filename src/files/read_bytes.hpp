// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "files/load_budget.hpp"

namespace nicol {

/// A whole file. Throws Error(file_not_found) unless `file` is a regular file that can be read.
/// `budget` is asked while it is read.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file, const LoadBudget& budget = {});

}  // namespace nicol
