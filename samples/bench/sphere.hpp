// SPDX-License-Identifier: MIT
// A sphere mesh of any size, with waves that shadow each other.
#pragma once

#include <cstdint>
#include <vector>

#include "common/handles.hpp"

/// Returns a sphere of radius 1 with about `vertices` vertices and waves of the given amplitude; 0: convex.
Mesh make_sphere(nicol_context context, std::uint32_t vertices, double amplitude);

/// Returns the positions of its vertices, three numbers each.
std::vector<float> sphere_positions(std::uint32_t vertices, double amplitude);
