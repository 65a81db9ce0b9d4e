// SPDX-License-Identifier: MIT
// The scenes of a folder.
#pragma once

#include <filesystem>
#include <vector>

/// Returns every *.xml, *.gltf and *.glb of the folder in the order of names. Throws Failure if the folder
/// cannot be read or has none, if a name has other characters than letters, digits, '.', '_' and '-', because
/// names are parts of URLs, or if two names differ only in their endings.
std::vector<std::filesystem::path> find_scenes(const std::filesystem::path& folder);
