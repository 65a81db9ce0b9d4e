// SPDX-License-Identifier: MIT
// Materials given as coefficient matrices over polarized spherical harmonics (PSH).
#pragma once

#include <filesystem>
#include <span>
#include <vector>

#include "files/load_budget.hpp"
#include "harmonics/operator.hpp"
#include "material/material.hpp"

namespace nicol {

/// Reads one matrix per channel, 1..16, from the SHMat archives of the paper's authors in the layout ISOBI2:
/// a member coeff [channel][index][p_out][p_in] of float64 or float32 over real harmonics, with
/// |m_in| = |m_out| and orders 0..lmax on both sides. Deviations from isotropy (Eq. 53), which are noise of
/// the projection, are averaged out. Throws what read_npz_member() throws, and Error(invalid_file) that names
/// file and member for a shape other than ISOBI2, a value that is not finite, and a codomain or harmonics
/// that the file states to be other than POLAR4 and REAL.
[[nodiscard]] std::vector<IsotropicMatrix> read_psh_matrix(const std::filesystem::path& path,
                                                           const LoadBudget& budget = {});

/// Writes matrices in the layout of read_psh_matrix(). All matrices must have one order, the same on both
/// sides, at most CoefficientMatrix::kMaxDenseOrder. Throws Error(invalid_argument) and Error(write_failed).
void write_psh_matrix(const std::filesystem::path& path, std::span<const IsotropicMatrix> channels);

/// Returns a material defined by coefficient matrices. evaluate() reconstructs the Mueller matrix at the two
/// directions and divides by the cosine that the matrices include; truncation makes the result ring and go
/// below zero. The outgoing side is interpolated between rows, with an error below 1e-3 of the largest value.
/// The matrices are multiplied by `scale`, 0..1e12, one value or one per channel. `symmetrize` drops the part
/// without mirror symmetry, which in measurements is mostly noise. A part up to 1e-6 of the norm, which is
/// rounding, is always dropped from the angular domain. Throws Error(invalid_argument).
[[nodiscard]] MaterialPtr psh_matrix_material(std::vector<IsotropicMatrix> channels,
                                              const std::vector<double>& scale = {1.0},
                                              bool symmetrize = false);

}  // namespace nicol
