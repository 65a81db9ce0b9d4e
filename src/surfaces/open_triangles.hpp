// SPDX-License-Identifier: MIT
// Triangles above which nothing lies.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

namespace nicol {

/// Boxes around a geometry's vertices, which find out whether a vertex lies above the plane of a triangle.
class OpenTriangles {
public:
    /// The positions must outlive the object.
    explicit OpenTriangles(std::span<const glm::vec3> positions);

    /// Returns whether no triangle of the geometry reaches above the front of a triangle, so that rays which
    /// start on the front, see leaving(), meet nothing. False for a triangle without an area.
    [[nodiscard]] bool open(const glm::uvec3& corners) const;

private:
    struct Box {
        glm::vec3 lower, upper;
    };
    /// Points above which dot(normal, point) is larger than `height`.
    struct Plane {
        glm::dvec3 normal;
        double height;
    };
    [[nodiscard]] bool any_above(const Plane& plane, std::size_t level, std::size_t box) const;

    std::span<const glm::vec3> positions_;
    std::vector<std::vector<Box>> levels_;  // boxes of consecutive positions, then of consecutive boxes
};

}  // namespace nicol
