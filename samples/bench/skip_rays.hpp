// SPDX-License-Identifier: MIT
// Rows of nicol-bench skip for rays of the bake.
#pragma once

#include <nicol.h>

#include <cstdint>
#include <vector>

#include "report.hpp"

/// Adds a row for each scene in which rays of the bake are not needed: first pictures of new scenes.
void add_ray_rows(nicol_context context, std::uint32_t size, Report& report);

/// Returns the largest difference of two images over the largest value of the second.
double largest_difference(const std::vector<float>& a, const std::vector<float>& b);
/// Returns the Stokes vectors of all channels.
std::vector<float> stokes_of(nicol_framebuffer framebuffer);
