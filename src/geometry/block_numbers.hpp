// SPDX-License-Identifier: MIT
// Numbers of vertices by which blocks of them lie together and face alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nicol {

/// Fewest vertices that are worth an order.
inline constexpr std::size_t kLeastOrdered = 1024;

/// Returns a number for each vertex: a permutation of 0, 1, ... in which the vertices of a block of kLanes
/// consecutive numbers, the first of which is a multiple of kLanes, have similar positions and normals.
/// Therefore a view shows either most vertices of a block or none, and skips whole blocks. A scene's blocks
/// are these only in instances whose first vertex is a multiple of kLanes. The numbers depend on nothing but
/// the arguments. normals: unit vectors, one for each position. Empty: there are fewer than kLeastOrdered
/// vertices, whose blocks take little time, and they keep their order.
[[nodiscard]] std::vector<std::uint32_t> block_numbers(std::span<const glm::vec3> positions,
                                                       std::span<const glm::vec3> normals);

}  // namespace nicol
