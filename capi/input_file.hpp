// SPDX-License-Identifier: MIT
// Files that calls read: on disk or in the caller's memory.
#pragma once

#include <filesystem>

#include "files/load_budget.hpp"
#include "nicol.h"

namespace nicol::capi {

/// A file to load, and the budget of the load, which has the source of the file.
struct InputFile {
    std::filesystem::path name;
    LoadBudget budget;
};

/// Both throw Error(invalid_argument) for arguments that describe no file.
InputFile input_file(const char* path, const LoadLimits& limits);
InputFile input_file(const nicol_memory_file* file, const LoadLimits& limits);

}  // namespace nicol::capi
