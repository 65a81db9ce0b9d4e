// SPDX-License-Identifier: MIT
// Errors of formats that a build leaves out. Hosts that bring their data as arrays build without them.
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

}  // namespace nicol
