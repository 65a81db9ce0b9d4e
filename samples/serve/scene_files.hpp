// SPDX-License-Identifier: MIT
// The scenes of a folder, and what their files hold.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

/// Every *.xml of the folder, in the order of their names. Throws Failure where it cannot be read, holds
/// none, or a name has other characters than letters, digits, '.', '_' and '-', of which URLs are made.
std::vector<std::filesystem::path> find_scenes(const std::filesystem::path& folder);

/// SHA-256 in hexadecimal of the scene file and of all files that it names as a quoted value: meshes, light,
/// materials and included scenes, these likewise. A "$name" in a value is what a <default> of the file says.
/// Files are identified by content, not by path or time.
std::string scene_digest(const std::filesystem::path& path);
