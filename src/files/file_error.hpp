// SPDX-License-Identifier: MIT
// Errors about the content of files, whose messages begin with the file's name.
#pragma once

#include <filesystem>
#include <string>

#include "error.hpp"

namespace nicol {

/// Throws Error(invalid_file).
[[noreturn]] inline void invalid_file(const std::filesystem::path& file, const std::string& what) {
    throw Error(ErrorCode::invalid_file, file.string() + ": " + what);
}

/// Throws Error(unsupported).
[[noreturn]] inline void unsupported_file(const std::filesystem::path& file, const std::string& what) {
    throw Error(ErrorCode::unsupported, file.string() + ": " + what);
}

}  // namespace nicol
