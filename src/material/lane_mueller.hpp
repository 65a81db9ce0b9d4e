// SPDX-License-Identifier: MIT
// Mueller matrices of sixteen points.
#pragma once

#include <array>

#include "simd/lanes.hpp"

namespace nicol {

/// Sixteen Mueller matrices, row-major like Mueller: m[4 row + column].
struct LaneMueller {
    std::array<Lanes, 16> m;
};

}  // namespace nicol
