// SPDX-License-Identifier: MIT
#include "shading/tangent_rotation.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {

glm::vec3 rotated_tangent(const TangentRotation& rotation, const TexturePoint& point, const TextureAxes& axes,
                          const glm::vec3& normal) {
    const auto [x, y] = surface_axes(axes, normal, true);
    glm::vec2 direction(1, 0);
    if (rotation.directions != nullptr) {
        const glm::vec2 of_texture = 2.0F * glm::vec2(rotation.directions->at(point)) - 1.0F;
        const float size = glm::length(of_texture);
        if (size > 0) direction = of_texture / size;
    }
    const auto cosine = static_cast<float>(std::cos(rotation.angle));
    const auto sine = static_cast<float>(std::sin(rotation.angle));
    return (cosine * direction.x - sine * direction.y) * x + (sine * direction.x + cosine * direction.y) * y;
}

}  // namespace nicol
