// SPDX-License-Identifier: MIT
// Look-up of a direction of a set that is near a given one.
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

    /// Returns the index of a direction near the given one, which is not 0: within 0.15 radians for a set of
    /// 2,048 or more, 0.2 for 1,000 and 0.3 for 256.
    [[nodiscard]] std::uint32_t of(const glm::vec3& direction) const;

private:
    std::vector<std::uint32_t> nearest_;
};

}  // namespace nicol
