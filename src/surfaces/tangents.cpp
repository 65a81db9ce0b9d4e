// SPDX-License-Identifier: MIT
#include "surfaces/tangents.hpp"

#include <algorithm>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

glm::dvec3 unit_or_zero(const glm::dvec3& v) {
    const double length = glm::length(v);
    return length > 0 ? v / length : glm::dvec3(0);
}

}  // namespace

TextureAxes texture_axes(const WorldGeometry& geometry, std::uint32_t triangle) {
    if (geometry.texcoords.empty()) return {};
    const glm::uvec3& t = geometry.triangles[triangle];
    return texture_axes({geometry.positions[t.x], geometry.positions[t.y], geometry.positions[t.z]},
                        geometry.texcoords[triangle]);
}

TextureAxes material_axes(const WorldGeometry& geometry, std::uint32_t triangle, const glm::vec3& weights,
                          const glm::vec3& normal, const TextureAxes& axes) {
    return geometry.tangents.empty() ? axes
                                     : tangent_axes(geometry.tangents[triangle], weights, normal, axes);
}

glm::vec3 tangent(const WorldGeometry& geometry, std::uint32_t triangle, const glm::vec3& weights) {
    const glm::uvec3& t = geometry.triangles[triangle];
    const glm::dvec3 normal = weights.x * geometry.normals[t.x] + weights.y * geometry.normals[t.y] +
                              weights.z * geometry.normals[t.z];
    // The direction of the normal matters to the second axis alone, which is not used.
    const glm::dvec3 along =
        material_axes(geometry, triangle, weights, glm::vec3(normal), texture_axes(geometry, triangle)).by_u;
    const double square = glm::dot(normal, normal);
    return unit_or_zero(square > 0 ? along - glm::dot(along, normal) / square * normal : along);
}

Frame frame_along(const glm::dvec3& normal, const glm::dvec3& tangent) {
    const glm::dvec3 x = tangent - glm::dot(tangent, normal) * normal;
    const double length = glm::length(x);
    if (!(length > 1e-6)) return theta_phi_frame(normal);
    return {x / length, glm::cross(normal, x / length), normal};
}

std::vector<glm::vec3> vertex_tangents(const WorldGeometry& geometry) {
    const auto anisotropic = [](const VertexRange& range) { return range.material->anisotropic(); };
    if (std::ranges::none_of(geometry.ranges, anisotropic)) return {};
    std::vector<glm::vec3> out(geometry.positions.size(), glm::vec3(0));
    for (std::uint32_t triangle = 0; triangle < geometry.triangles.size(); ++triangle) {
        const glm::uvec3& t = geometry.triangles[triangle];
        const TextureAxes axes = texture_axes(geometry, triangle);
        for (glm::length_t k = 0; k < 3; ++k) {
            glm::vec3 corner(0);
            corner[k] = 1;
            out[t[k]] +=
                unit_or_zero(material_axes(geometry, triangle, corner, geometry.normals[t[k]], axes).by_u);
        }
    }
    for (glm::vec3& along : out) along = unit_or_zero(along);
    return out;
}

}  // namespace nicol
