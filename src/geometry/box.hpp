// SPDX-License-Identifier: MIT
// Boxes around meshes.
#pragma once

#include <glm/common.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "geometry/mesh.hpp"

namespace nicol {

/// Box along the axes.
struct Box {
    glm::dvec3 lower{std::numeric_limits<double>::infinity()};
    glm::dvec3 upper{-std::numeric_limits<double>::infinity()};

    bool operator==(const Box&) const = default;
    [[nodiscard]] bool empty() const { return lower.x > upper.x; }
    /// Grows the box by a point.
    void add(const glm::dvec3& place) {
        lower = glm::min(lower, place);
        upper = glm::max(upper, place);
    }
    /// Grows the box by all vertices of a mesh.
    void add(const Mesh& mesh, const glm::dmat4& to_world) {
        for (const glm::vec3& position : mesh.positions) add(glm::dvec3(to_world * glm::dvec4(position, 1)));
    }
};

}  // namespace nicol
