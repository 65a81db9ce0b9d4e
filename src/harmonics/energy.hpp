// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "harmonics/psh.hpp"
#include "polarization/stokes.hpp"

namespace nicol {

/// Returns [l]: squares of the coefficients of order l summed over the degrees m, for each p = 0..3.
[[nodiscard]] std::vector<Stokes> energy_per_order(const PshVector& field, int channel);

}  // namespace nicol
