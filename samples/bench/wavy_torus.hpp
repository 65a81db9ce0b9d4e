// SPDX-License-Identifier: MIT
// A coarse mesh that shadows itself.
#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <vector>

struct Triangles {
    std::vector<std::array<double, 3>> positions, normals;
    std::vector<std::array<std::size_t, 3>> corners;
};

/// Returns a torus with waves, of rows x columns vertices. Its axis is y, and it is 3 wide.
Triangles wavy_torus(std::size_t rows, std::size_t columns);

/// Splits each triangle into four in the same plane, with normals as shading interpolates them.
Triangles split(const Triangles& mesh);

/// Throws std::runtime_error.
void write_obj(const std::filesystem::path& path, const Triangles& mesh);
