// SPDX-License-Identifier: MIT
// Coefficients of light in the .npz files of the Python package polarsh ("SHVec").
#pragma once

#include <filesystem>

#include "files/load_budget.hpp"
#include "harmonics/psh.hpp"

namespace nicol {

/// Reads the member `coeff` [channel][psh_index(l, m)][4] (or without the channel axis) with `cod_type`
/// "POLAR4", or [channel][psh_index(l, m)] with "SCALAR", which is unpolarized; `sh_type` must be "REAL".
/// Signs, order, frames and domain (propagation directions) are those of PshVector. Throws what
/// read_npz_member() throws; Error(unsupported) for other types; Error(invalid_file) that names the file for
/// more than 16 channels, a number of coefficients that is no square or exceeds kMaxOrder, values that are
/// not finite, and p = 1, 2 below l = 2 that are not zero.
[[nodiscard]] PshVector read_psh_vector(const std::filesystem::path& path, const LoadBudget& budget = {});

/// Writes coeff [channel][psh_index(l, m)][4], cod_type POLAR4 and sh_type REAL. The file appears under its
/// name only when it is complete. Throws Error(invalid_argument) for no channel or more than 16, and
/// Error(write_failed) that names the path.
void write_psh_vector(const std::filesystem::path& path, const PshVector& coefficients);

}  // namespace nicol
