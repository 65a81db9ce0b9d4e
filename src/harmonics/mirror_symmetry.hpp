// SPDX-License-Identifier: MIT
// What of an isotropic operator commutes with the mirror images in planes through the axis.
#pragma once

#include <cstddef>

#include "harmonics/operator.hpp"

namespace nicol {

/// The square of a block's element, times this, is that of the entries of the real matrix it stands for, by
/// lanes: 0 to 3 for s0, s3, w, conj w. Summed over all elements it is the Frobenius norm squared.
[[nodiscard]] double block_weight(int m, std::size_t out, std::size_t in);

/// The norm of what breaks the symmetry over that of all, 0 to 1; 0 for zero matrices.
[[nodiscard]] double asymmetry(const IsotropicMatrix& matrix);

/// Leaves the part that has the symmetry: the mean of the operator and its mirror image.
void symmetrize(IsotropicMatrix& matrix);

}  // namespace nicol
