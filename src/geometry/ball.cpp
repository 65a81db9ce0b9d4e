// SPDX-License-Identifier: MIT
#include "geometry/ball.hpp"

#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace nicol {

Ball ball_around(std::span<const glm::vec3> points) {
    if (points.empty()) return {};
    glm::vec3 low = points.front();
    glm::vec3 high = low;
    for (const glm::vec3& point : points) {
        low = glm::min(low, point);
        high = glm::max(high, point);
    }
    const glm::vec3 centre = low + 0.5F * (high - low);
    double radius = 0;
    for (const glm::vec3& point : points) {
        radius = std::max(radius, glm::distance(glm::dvec3(point), glm::dvec3(centre)));
    }
    return {.centre = centre, .radius = static_cast<float>(1.00001 * radius)};
}

}  // namespace nicol
