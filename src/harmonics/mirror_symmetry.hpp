// SPDX-License-Identifier: MIT
// Symmetry of isotropic operators under the mirror images in planes through the axis.
#pragma once

#include <cstddef>

#include "harmonics/operator.hpp"

namespace nicol {

/// Returns the factor that converts the square of a block's element to the sum of squares of the real matrix
/// entries for which the element stands. Lanes 0 to 3 are s0, s3, w, conj w. Summed over all elements the
/// result is the squared Frobenius norm.
[[nodiscard]] double block_weight(int m, std::size_t out, std::size_t in);

/// Returns the norm of the part that breaks the symmetry, divided by the norm of the whole, 0 to 1; 0 for
/// zero matrices.
[[nodiscard]] double asymmetry(const IsotropicMatrix& matrix);

/// Keeps only the part that has the symmetry, which is the mean of the operator and its mirror image.
void symmetrize(IsotropicMatrix& matrix);

}  // namespace nicol
