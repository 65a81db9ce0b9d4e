// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

namespace nicol {

/// A whole file. Throws Error(file_not_found) unless `file` is a regular file that can be read.
[[nodiscard]] std::string read_bytes(const std::filesystem::path& file);

}  // namespace nicol
