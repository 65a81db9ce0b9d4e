// SPDX-License-Identifier: MIT
// What is wrong with a file, with its name in front.
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
