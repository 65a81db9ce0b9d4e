// SPDX-License-Identifier: MIT
// Scenes whose first picture costs a lot.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "recipe.hpp"

struct StartScene {
    std::string name;
    std::string file;
    std::uint32_t size;  ///< pixels of a side
    Recipe recipe;
};

/// Writes scenes to a folder: one sphere each of four materials, projected to order 16 and split to 64; and
/// with default options a cloth of 120,000 vertices, thirty spheres and cubes on a floor, and a million
/// triangles.
std::vector<StartScene> write_start_scenes(const std::filesystem::path& folder);
