// SPDX-License-Identifier: MIT
// Transposition between vertices one after the other and vertices side by side.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>

#include "simd/lanes.hpp"

namespace nicol {

/// Sets lanes[j][i] = rows[i][j] for j < count.
void to_lanes(const std::array<const float*, kLanes>& rows, std::size_t count, Lanes* lanes);

/// Interpolates between each row and the row `step` floats further:
/// lanes[j][i] = rows[i][j] + fraction[i] (rows[i][step + j] - rows[i][j]) for j < count.
void to_lanes_between(const std::array<const float*, kLanes>& rows, std::size_t step, const Lanes& fraction,
                      std::size_t count, Lanes* lanes);

/// Adds three weighted rows: lanes[j][i] = sum over k of weights[k][i] rows[k][i][j] for j < count.
void to_lanes_weighted(const std::array<std::array<const float*, kLanes>, 3>& rows,
                       const std::array<Lanes, 3>& weights, std::size_t count, Lanes* lanes);

/// Sets lanes[p][i] = from[i][p] for p < 4 and i < kLanes.
void take_fours(const glm::vec4* from, Lanes* lanes);

/// Assigns or adds lanes[p][i] to out[i][p] for p < 4 and i < count if show[i] != 0.
void put_fours(const Lanes* lanes, const std::uint8_t* show, std::size_t count, glm::vec4* out);
void add_fours(const Lanes* lanes, const std::uint8_t* show, std::size_t count, glm::vec4* out);
/// Adds lanes[p][i] to out[i][p] for p < 4 and every i < count.
void add_fours(const Lanes* lanes, std::size_t count, glm::vec4* out);

}  // namespace nicol
