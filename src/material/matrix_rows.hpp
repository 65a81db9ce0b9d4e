// SPDX-License-Identifier: MIT
// Conversions between isotropic coefficient matrices and rows of responses.
#pragma once

#include <span>

#include "harmonics/light_layout.hpp"
#include "harmonics/operator.hpp"

namespace nicol {

/// Computes the rows [p][pairing][j] (see ResponseTable) of a matrix at an outgoing zenith angle in [0, pi]:
/// its outgoing side evaluated in the angular domain. `pairings` is 1 or 2: the first has the
/// mirror-symmetric part of the matrix, the second the rest. Entries beyond order_in() are zero.
void rows_from_matrix(const IsotropicMatrix& matrix, double theta_out, const LightLayout& layout,
                      std::size_t pairings, std::span<double> rows);

/// Inverts rows_from_matrix() one angle at a time: adds to `matrix` the part of its blocks that comes from
/// outgoing light with these rows on a circle of latitude. The layout has LightKind::full and the matrix's
/// incoming order. `weight` is the circle's weight in the integral over cos(theta).
void add_circle(IsotropicMatrix& matrix, double theta_out, double weight, const LightLayout& layout,
                std::size_t pairings, std::span<const double> rows);

}  // namespace nicol
