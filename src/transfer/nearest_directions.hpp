// SPDX-License-Identifier: MIT
// Look-up of the direction of a set that is nearest to a given one.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "visibility/visibility_directions.hpp"

namespace nicol {

/// Directions of a set by the cells of a cube's faces. Immutable; threads share it.
class NearestDirections {
public:
    explicit NearestDirections(const DirectionSet& directions);

    /// Returns the index of a direction that is within 0.15 radians of the given one, which is not 0.
    [[nodiscard]] std::uint32_t of(const glm::vec3& direction) const;

private:
    std::vector<std::uint32_t> nearest_;
};

}  // namespace nicol
