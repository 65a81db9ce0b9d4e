// SPDX-License-Identifier: MIT
// Sixteen points and the camera that looks at them, for loops of every instruction set.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <span>

#include "polarization/viewpoint.hpp"
#include "simd/lane_phases.hpp"

namespace nicol {

struct LanePoints {
    DoubleLanes x, y, z;
};

/// `from`: up to sixteen; lanes beyond them repeat the first.
[[nodiscard]] LanePoints lane_points(std::span<const glm::vec3> from);

/// A Viewpoint.
struct LaneCamera {
    bool orthographic;
    std::array<double, 3> eye, backward, up, right;
};

[[nodiscard]] LaneCamera lane_camera(const Viewpoint& view);

}  // namespace nicol
