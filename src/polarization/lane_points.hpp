// SPDX-License-Identifier: MIT
// Sixteen points or directions side by side.
#pragma once

#include <glm/vec3.hpp>
#include <span>

#include "simd/lane_phases.hpp"
#include "simd/lanes.hpp"

namespace nicol {

/// Three numbers of each of sixteen vertices.
struct LaneVectors {
    Lanes x, y, z;
};

/// The same where single precision loses too much.
struct LanePoints {
    DoubleLanes x, y, z;
};

/// `from`: up to sixteen; lanes beyond them repeat the first.
[[nodiscard]] LanePoints lane_points(std::span<const glm::vec3> from);

}  // namespace nicol
