// SPDX-License-Identifier: MIT
// Files that are given as scenes by mistake.
#pragma once

#include <filesystem>
#include <string>

#include "files/file_source.hpp"

namespace nicol::scene {

/// Returns what a file is if its first bytes or its suffix tell that it is no scene, such as "a PNG image",
/// or a scene of the other format than its name says. Returns "" for all others and for files that cannot be
/// read.
[[nodiscard]] std::string kind_of_other_file(const std::filesystem::path& file, const FileSource& files);

}  // namespace nicol::scene
