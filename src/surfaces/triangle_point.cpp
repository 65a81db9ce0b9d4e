// SPDX-License-Identifier: MIT
#include "surfaces/triangle_point.hpp"

#include <glm/geometric.hpp>

#include "surfaces/triangle_offset.hpp"

namespace nicol {

glm::dvec3 area_vector(const WorldGeometry& geometry, std::uint32_t triangle) {
    const glm::uvec3& corners = geometry.triangles[triangle];
    const glm::dvec3 first(geometry.positions[corners.x]);
    return glm::cross(glm::dvec3(geometry.positions[corners.y]) - first,
                      glm::dvec3(geometry.positions[corners.z]) - first) /
           2.0;
}

TrianglePoint triangle_point(const WorldGeometry& geometry, std::uint32_t triangle, double b1, double b2,
                             const glm::dvec3& otherwise) {
    const glm::uvec3& corners = geometry.triangles[triangle];
    const glm::dvec3 weights(1 - b1 - b2, b1, b2);
    const auto mean = [&](const auto& values) {
        return weights.x * glm::dvec3(values[corners.x]) + weights.y * glm::dvec3(values[corners.y]) +
               weights.z * glm::dvec3(values[corners.z]);
    };
    const glm::dvec3 across = area_vector(geometry, triangle);
    const double area = glm::length(across);
    const glm::dvec3 facet = area > 0 ? across / area : otherwise;
    const glm::dvec3 normal = mean(geometry.normals);
    const double length = glm::length(normal);
    return {.position = mean(geometry.positions),
            .facet = facet,
            .normal = length > 0 ? normal / length : facet,
            .offset = offset_of_triangle(geometry, triangle)};
}

TexturePoint texture_point(const WorldGeometry& geometry, std::uint32_t triangle, const glm::vec3& weights) {
    return texture_point(weights, geometry.texcoords.empty() ? nullptr : &geometry.texcoords[triangle],
                         geometry.colors.empty() ? nullptr : &geometry.colors[triangle]);
}

}  // namespace nicol
