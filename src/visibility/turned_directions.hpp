// SPDX-License-Identifier: MIT
// Visibility of a vertex after its object has rotated, as far as the object's own shadow goes.
#pragma once

#include <cstdint>
#include <glm/mat3x3.hpp>
#include <span>
#include <vector>

#include "visibility/visibility_directions.hpp"

namespace nicol {

/// For each direction, a direction that a rotation takes close to it.
class TurnedDirections {
public:
    TurnedDirections(const DirectionSet& directions, const glm::dmat3& rotation);

    /// Sets the bits of a vertex, of the layout of Visibility::at(), from its bits before the rotation.
    void turn(std::span<const std::uint64_t> before, std::span<std::uint64_t> bits) const;

private:
    std::vector<std::uint32_t> nearest_;
};

}  // namespace nicol
