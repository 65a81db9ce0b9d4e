// SPDX-License-Identifier: MIT
// Solid spheres.
#pragma once

#include <glm/vec3.hpp>
#include <span>

namespace nicol {

/// A solid sphere.
struct Ball {
    glm::vec3 centre{0};
    float radius = 0;
    bool operator==(const Ball&) const = default;
};

/// Returns the ball around the middle of the points' box; radius 0 at the origin if there are no points.
[[nodiscard]] Ball ball_around(std::span<const glm::vec3> points);

}  // namespace nicol
