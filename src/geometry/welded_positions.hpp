// SPDX-License-Identifier: MIT
// Vertices that share a position.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nicol {

/// Returns for each vertex the first one at its position.
[[nodiscard]] std::vector<std::uint32_t> welded_positions(std::span<const glm::vec3> positions);

}  // namespace nicol
