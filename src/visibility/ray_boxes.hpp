// SPDX-License-Identifier: MIT
// Rays of a bake that meet boxes.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "geometry/box.hpp"
#include "visibility/visibility_directions.hpp"

namespace nicol {

/// Adds the rays from a point, in the directions of a bake, that meet a box. May add a few more. Bits are by
/// bundle; bit i is that of the bundle's direction i.
void add_rays_to_box(const DirectionSet& directions, const glm::vec3& origin, const Box& box,
                     std::span<std::uint16_t> bits);

}  // namespace nicol
