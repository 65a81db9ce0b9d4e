// SPDX-License-Identifier: MIT
// The user's cache folder, in which programs keep tables and bakes unless told otherwise.
#pragma once

#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <string>

/// Returns $XDG_CACHE_HOME/nicol, else ~/.cache/nicol, and makes the folder. Returns "" if NICOL_CACHE is
/// set, even to nothing, because it then decides; and if the folder cannot be made or written.
inline std::string user_cache_folder() {
    namespace fs = std::filesystem;
    if (std::getenv("NICOL_CACHE") != nullptr) return "";
    const auto absolute = [](const char* variable) {
        const char* const value = std::getenv(variable);
        const fs::path path = value != nullptr ? value : "";
        return path.is_absolute() ? path : fs::path();
    };
    fs::path root = absolute("XDG_CACHE_HOME");
    if (root.empty() && !absolute("HOME").empty()) root = absolute("HOME") / ".cache";
    if (root.empty()) return "";
    const fs::path folder = root / "nicol";
    std::error_code failed;
    fs::create_directories(folder, failed);
    return !failed && access(folder.c_str(), W_OK | X_OK) == 0 ? folder.string() : "";
}
