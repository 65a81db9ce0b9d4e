// SPDX-License-Identifier: MIT
// Sheets of the paper's figures 8 and 9: spin-2 spherical harmonics, and light as their sum.
#pragma once

#include <filesystem>
#include <string>

/// Draws the spin-2 spherical harmonics of order 2 (figure 8) with panels of `size` pixels. Columns are the
/// degrees m. Rows show the angle of polarization as a hue from the north, from the side and from the south,
/// and s1 and s2 in the theta-phi frame from the side.
void write_spin_harmonics(std::size_t size, const std::string& path);

/// Draws a light of coefficients as the sum of its orders (figure 9) with panels of `size` pixels. Columns
/// are s0, s1 and s2. Rows are all orders, single orders and the sums up to orders 4 and 9.
void write_decomposition(const std::filesystem::path& light, std::size_t size, const std::string& path);
