// SPDX-License-Identifier: MIT
// Between vertices one after the other and vertices side by side.
#pragma once

#include <array>
#include <cstddef>

#include "transfer/lanes.hpp"

namespace nicol {

/// lanes[j][i] = rows[i][j] for j < count.
void to_lanes(const std::array<const float*, kLanes>& rows, std::size_t count, Lanes* lanes);

/// rows[i][j] = lanes[j][i] for i < used and j < count.
void from_lanes(const Lanes* lanes, std::size_t count, std::size_t used,
                const std::array<float*, kLanes>& rows);

}  // namespace nicol
