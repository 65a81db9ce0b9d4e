// SPDX-License-Identifier: MIT
#include "surfaces/tangents.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

glm::dvec3 along_u(const WorldGeometry& geometry, std::uint32_t triangle) {
    const glm::uvec3& t = geometry.triangles[triangle];
    const std::array corners{geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]};
    return unit_or_zero(texture_axes(corners, geometry.texcoords[triangle]).by_u);
}

}  // namespace

glm::vec3 tangent(const WorldGeometry& geometry, std::uint32_t triangle, const glm::vec3& weights) {
    const glm::dvec3 along = along_u(geometry, triangle);
    const glm::uvec3& t = geometry.triangles[triangle];
    const glm::dvec3 normal =
        unit_or_zero(weights.x * geometry.normals[t.x] + weights.y * geometry.normals[t.y] +
                     weights.z * geometry.normals[t.z]);
    return unit_or_zero(along - glm::dot(along, normal) * normal);
}

std::vector<glm::vec3> vertex_tangents(const WorldGeometry& geometry) {
    const auto anisotropic = [](const VertexRange& range) { return range.material->anisotropic(); };
    if (std::ranges::none_of(geometry.ranges, anisotropic)) return {};
    std::vector<glm::vec3> out(geometry.positions.size(), glm::vec3(0));
    for (std::uint32_t triangle = 0; triangle < geometry.triangles.size(); ++triangle) {
        const glm::uvec3& t = geometry.triangles[triangle];
        const glm::vec3 along(along_u(geometry, triangle));
        for (const std::uint32_t vertex : {t.x, t.y, t.z}) out[vertex] += along;
    }
    for (glm::vec3& along : out) along = unit_or_zero(along);
    return out;
}

}  // namespace nicol
