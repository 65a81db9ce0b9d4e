// SPDX-License-Identifier: MIT
// Start of a bake's rays beside vertices and beside the middles of edges.
#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "geometry/unit.hpp"

namespace nicol {

struct RayStart {
    glm::vec3 normal;  ///< normal of any length
    glm::vec3 shift;   ///< vector from the point to the start of its rays
};

/// Returns the start of rays beside the middle of an edge.
[[nodiscard]] inline RayStart middle_of(const RayStart& a, const RayStart& b) {
    const glm::vec3 sum = 0.5F * a.normal + 0.5F * b.normal;
    const glm::vec3 normal = glm::dot(sum, sum) > 1e-12F ? sum : a.normal;
    const glm::vec3 up = unit(normal);
    const glm::vec3 mean = 0.5F * a.shift + 0.5F * b.shift;
    const float along = glm::max(glm::dot(a.shift, unit(a.normal)), glm::dot(b.shift, unit(b.normal)));
    return {.normal = normal, .shift = mean + (along - glm::dot(mean, up)) * up};
}

}  // namespace nicol
