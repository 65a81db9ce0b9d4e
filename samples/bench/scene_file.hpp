// SPDX-License-Identifier: MIT
// Scene files that sub-commands write.
#pragma once

#include <filesystem>
#include <string>

/// Light of the photograph of a forest.
inline constexpr const char* kForestLight =
    R"(<emitter type="envmap"><string name="filename" value=")" NICOL_BENCH_ASSETS
    R"(/forest.exr"/></emitter>)";

/// Writes a scene seen by a perspective camera of 40 degrees. origin, target, up: of its lookat, as in the
/// file. content: lights and shapes. Throws std::runtime_error.
void write_scene(const std::filesystem::path& path, const std::string& origin, const std::string& target,
                 const std::string& content, const std::string& up = "0,1,0");
