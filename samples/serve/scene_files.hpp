// SPDX-License-Identifier: MIT
// The scenes of a folder.
#pragma once

#include <filesystem>
#include <vector>

/// Every *.xml of the folder, in the order of their names. Throws Failure where it cannot be read, holds
/// none, or a name has other characters than letters, digits, '.', '_' and '-', of which URLs are made.
std::vector<std::filesystem::path> find_scenes(const std::filesystem::path& folder);
