// SPDX-License-Identifier: MIT
// Materials given as PSH coefficient matrices.
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "files/load_budget.hpp"
#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// Reads the authors' SHMat archives in the layout ISOBI2: a member coeff [channel][index][p_out][p_in] of
/// float64 or float32 over real harmonics, |m_in| = |m_out|, orders 0..lmax on both sides. One matrix a
/// channel, 1..16. Deviations from isotropy (Eq. 53), which are noise of the projection, are averaged away.
/// Throws what read_npz_member() throws, and Error(invalid_file) naming file and member for a shape that is
/// no ISOBI2, a value that is not finite and, if the file states them, a codomain or harmonics other than
/// POLAR4 and REAL.
[[nodiscard]] std::vector<IsotropicMatrix> read_psh_matrix(const std::filesystem::path& path,
                                                           const LoadBudget& budget = {});

/// Writes the same layout. All matrices must have one order, the same on both sides, at most
/// CoefficientMatrix::kMaxDenseOrder. Throws Error(invalid_argument) and Error(write_failed).
void write_psh_matrix(const std::filesystem::path& path, std::span<const IsotropicMatrix> channels);

/// A material defined by coefficient matrices. evaluate() reconstructs the Mueller matrix at the two
/// directions and divides by the cosine that the matrices include; truncation makes it ring and go below
/// zero. The outgoing side is interpolated between rows (error below 1e-3 of the largest value). The matrices
/// are multiplied by `scale`, finite and >= 0, one value or one per channel. symmetrize: drops what breaks
/// mirror symmetry, in measurements mostly their noise; up to 1e-6 of the norm, which is rounding, it is
/// always dropped from the angular domain. Throws Error(invalid_argument).
[[nodiscard]] MaterialPtr psh_matrix_material(std::vector<IsotropicMatrix> channels,
                                              const std::vector<double>& scale = {1.0},
                                              bool symmetrize = false);

}  // namespace nicol
