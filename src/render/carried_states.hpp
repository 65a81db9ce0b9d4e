// SPDX-License-Identifier: MIT
// States of vertices of a bake after a change of the scene.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "surfaces/scene_geometry.hpp"

namespace nicol {

/// Returns the state, as of baked_vertices(), that each vertex of changed surfaces had in the former bake.
/// 0: it was not in it, or the change has moved it and more than shifted it. before: states in that bake;
/// empty: all were traced. outdated: states of vertices of which `before` is 0 because they are outdated;
/// empty: there are none.
[[nodiscard]] std::vector<std::uint8_t> carried_states(const SceneGeometry::Change& change,
                                                       std::span<const std::uint8_t> before,
                                                       std::span<const std::uint8_t> outdated,
                                                       std::size_t vertices);

}  // namespace nicol
