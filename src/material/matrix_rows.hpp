// SPDX-License-Identifier: MIT
// Between isotropic coefficient matrices and rows of responses.
#pragma once

#include <span>

#include "harmonics/light_layout.hpp"
#include "harmonics/operator.hpp"

namespace nicol {

/// Rows [p][pairing][j] (see ResponseTable) of a matrix at an outgoing zenith angle in [0, pi]: its outgoing
/// side evaluated in the angular domain. pairings: 1 or 2; the first one has the part of the matrix with
/// mirror symmetry, the second one the rest. Numbers beyond the matrix's incoming order are zero.
void rows_from_matrix(const IsotropicMatrix& matrix, double theta_out, const LightLayout& layout,
                      std::size_t pairings, std::span<double> rows);

/// The inverse, one angle at a time: adds to `matrix` the part of its blocks that comes from outgoing light
/// on a circle of latitude with these rows (of a layout with LightKind::full and the matrix's incoming
/// order). weight: of the circle in the integral over cos(theta).
void add_circle(IsotropicMatrix& matrix, double theta_out, double weight, const LightLayout& layout,
                std::size_t pairings, std::span<const double> rows);

}  // namespace nicol
