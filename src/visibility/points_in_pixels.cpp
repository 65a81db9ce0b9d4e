// SPDX-License-Identifier: MIT
#include "visibility/points_in_pixels.hpp"

#include <glm/common.hpp>

#include "geometry/position_hash.hpp"

namespace nicol {
namespace {

constexpr float kNormalsOfCell = 0.5F;  // sides of a cell of unit normals

}  // namespace

std::uint32_t PointsInPixels::add(const glm::vec3& position, const glm::vec3& normal, std::uint32_t number) {
    if (!(pixel_ > 0)) return number;
    const std::size_t cell =
        geometry::hash_of(glm::floor(position / pixel_), glm::round(normal / kNormalsOfCell));
    return *first_.try_emplace(cell, number).first;
}

}  // namespace nicol
