// SPDX-License-Identifier: MIT
// The JSON of a glTF file before tinygltf reads it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>
#include <vector>

#include "files/json.hpp"
#include "files/load_budget.hpp"

namespace nicol::scene {

/// Returns the members of a glTF file that the functions below use, or no object if the text is malformed. A
/// JsonRoom of the text must exist.
[[nodiscard]] Json gltf_members(std::string_view text, const LoadBudget& budget);

/// Returns the byteLength of each buffer that has a file of its own, in order; 0 if it is not usable.
[[nodiscard]] std::vector<std::uint64_t> lengths_of_buffers(const Json& members);

/// Throws Error(invalid_file) that names the element if an optional number that tinygltf may ignore is
/// malformed, or if a node's light has no number. Versions of tinygltf differ in what they refuse.
void check_gltf_members(const Json& members, const std::filesystem::path& file);

}  // namespace nicol::scene
