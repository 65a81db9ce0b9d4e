// SPDX-License-Identifier: MIT
// Kinds of files by their content.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "files/file_source.hpp"

namespace nicol {

/// Returns the suffix, such as ".glb", of files with this content that Nicol reads. Text that begins as no
/// other format is ".obj"; other content is "".
[[nodiscard]] std::string suffix_of_content(std::string_view bytes);

namespace scene {

/// Returns what a file is if its first bytes or its suffix tell that it is no scene, such as "a PNG image",
/// or a scene of the other format than its name says. Returns "" for all others and for files that cannot be
/// read.
[[nodiscard]] std::string kind_of_other_file(const std::filesystem::path& file, const FileSource& files);

}  // namespace scene
}  // namespace nicol
