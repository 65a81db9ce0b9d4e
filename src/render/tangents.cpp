// SPDX-License-Identifier: MIT
#include "render/tangents.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

#include "shading/normal_variation.hpp"

namespace nicol {
namespace {

glm::vec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? glm::vec3(v / length) : glm::vec3(0);
}

}  // namespace

glm::vec3 tangent(const WorldGeometry& geometry, std::uint32_t triangle) {
    const glm::uvec3& t = geometry.triangles[triangle];
    const std::array corners{geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]};
    return unit_or_zero(texture_axes(corners, geometry.texcoords[triangle]).by_u);
}

std::vector<glm::vec3> vertex_tangents(const WorldGeometry& geometry) {
    const auto anisotropic = [](const VertexRange& range) { return range.material->anisotropic(); };
    if (std::ranges::none_of(geometry.ranges, anisotropic)) return {};
    std::vector<glm::vec3> out(geometry.positions.size(), glm::vec3(0));
    for (std::uint32_t triangle = 0; triangle < geometry.triangles.size(); ++triangle) {
        const glm::uvec3& t = geometry.triangles[triangle];
        const glm::vec3 along = tangent(geometry, triangle);
        for (const std::uint32_t vertex : {t.x, t.y, t.z}) out[vertex] += along;
    }
    for (glm::vec3& along : out) along = unit_or_zero(along);
    return out;
}

}  // namespace nicol
