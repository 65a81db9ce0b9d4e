// SPDX-License-Identifier: MIT
#include "shading/normal_variation.hpp"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

namespace nicol {
namespace {

// Unit, or `otherwise` where there is no direction.
glm::vec3 direction(const glm::vec3& v, const glm::vec3& otherwise) {
    const float square = glm::dot(v, v);
    return square > 0 && square < std::numeric_limits<float>::infinity() ? v / std::sqrt(square) : otherwise;
}

glm::vec3 mapped(const NormalVariation& variation, const TexturePoint& point, const TextureAxes& axes,
                 const glm::vec3& n) {
    const glm::vec3 x = direction(axes.by_u - glm::dot(axes.by_u, n) * n, glm::vec3(0));
    if (x == glm::vec3(0)) return n;
    glm::vec3 y = glm::cross(n, x);
    if (variation.mirrored_y && glm::dot(y, axes.by_v) > 0) y = -y;
    const glm::vec3 local = 2.0F * glm::vec3(variation.texture->at(point)) - 1.0F;
    return direction(local.x * x + local.y * y + local.z * n, n);
}

glm::vec3 bumped(const NormalVariation& variation, const TexturePoint& point, const TextureAxes& axes,
                 const glm::vec3& n) {
    const glm::vec2 slope = static_cast<float>(variation.scale) * variation.texture->gradient(point);
    const glm::vec3 by_u = axes.by_u + (slope.x - glm::dot(n, axes.by_u)) * n;
    const glm::vec3 by_v = axes.by_v + (slope.y - glm::dot(n, axes.by_v)) * n;
    const glm::vec3 turned = direction(glm::cross(by_u, by_v), n);
    return glm::dot(turned, n) < 0 ? -turned : turned;
}

}  // namespace

TextureAxes texture_axes(const std::array<glm::vec3, 3>& positions,
                         const std::array<glm::vec2, 3>& texcoords) {
    const glm::vec3 along1 = positions[1] - positions[0];
    const glm::vec3 along2 = positions[2] - positions[0];
    const glm::vec2 d1 = texcoords[1] - texcoords[0];
    const glm::vec2 d2 = texcoords[2] - texcoords[0];
    const float area = d1.x * d2.y - d1.y * d2.x;
    if (area == 0) return {};
    return {.by_u = (d2.y * along1 - d1.y * along2) / area, .by_v = (d1.x * along2 - d2.x * along1) / area};
}

glm::vec3 turned_normal(const NormalVariation& variation, const TexturePoint& point, const TextureAxes& axes,
                        const glm::vec3& normal, bool back) {
    if (axes.by_u == glm::vec3(0) && axes.by_v == glm::vec3(0)) return normal;
    const glm::vec3 front = back ? -normal : normal;
    const glm::vec3 turned = variation.kind == NormalVariation::Kind::map
                                 ? mapped(variation, point, axes, front)
                                 : bumped(variation, point, axes, front);
    return back ? turned - 2 * glm::dot(turned, front) * front : turned;
}

glm::vec3 facing(const glm::vec3& turned, const glm::vec3& normal, const glm::vec3& towards_viewer) {
    // Microfacets have no limit at the horizon itself.
    constexpr float edge_on = 0.02F;
    const float least = std::min(edge_on, glm::dot(normal, towards_viewer));
    const float cosine = glm::dot(turned, towards_viewer);
    if (cosine >= least) return turned;
    return direction(turned + (least - cosine) * towards_viewer, normal);
}

}  // namespace nicol
