// SPDX-License-Identifier: MIT
// Names of the four files of a cube map.
#pragma once

#include <filesystem>
#include <optional>

namespace nicol {

/// "NAME" of "NAME_s0.exr" .. "NAME_s3.exr"; none for other paths.
[[nodiscard]] std::optional<std::filesystem::path> cube_cross_stem(const std::filesystem::path& file);

/// "NAME_s<component>.exr".
[[nodiscard]] std::filesystem::path cube_cross_file(const std::filesystem::path& stem, int component);

}  // namespace nicol
