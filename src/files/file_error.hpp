// SPDX-License-Identifier: MIT
// Errors about files, whose messages begin with the file's name.
#pragma once

#include <filesystem>
#include <string>

#include "error.hpp"

namespace nicol {

/// Throws Error(unsupported) that names the file, its kind and the option of CMake that brings it back.
[[noreturn]] inline void refuse_left_out_format(const std::filesystem::path& file, const std::string& kind,
                                                const std::string& option) {
    throw Error(ErrorCode::unsupported, file.string() + ": this build of Nicol has no " + kind + " (" +
                                            option + " was OFF); give the data as arrays");
}

/// Throws Error(invalid_file).
[[noreturn]] inline void invalid_file(const std::filesystem::path& file, const std::string& what) {
    throw Error(ErrorCode::invalid_file, file.string() + ": " + what);
}

/// Throws Error(unsupported).
[[noreturn]] inline void unsupported_file(const std::filesystem::path& file, const std::string& what) {
    throw Error(ErrorCode::unsupported, file.string() + ": " + what);
}

}  // namespace nicol
