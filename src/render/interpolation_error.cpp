// SPDX-License-Identifier: MIT
#include "render/interpolation_error.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {
namespace {

constexpr std::size_t kMostTriangles = 4096;

// How much of what is reflected varies with the direction at all, as measured on coarse meshes in light of
// lamps and of photographs (nicol-bench coarse).
constexpr double kVarying = 0.3;

double highest_order(const Material& material, int order) {
    double narrowest = 1;
    for (int t = 0; t < material.terms(); ++t) narrowest = std::min(narrowest, material.lobe_width(t));
    return std::min(1 / narrowest, static_cast<double>(order));
}

}  // namespace

double interpolation_error(const WorldGeometry& geometry, const Viewpoint& view, int order) {
    std::vector<double> orders;
    for (const VertexRange& range : geometry.ranges) orders.push_back(highest_order(*range.material, order));
    const std::size_t step = (geometry.triangles.size() + kMostTriangles - 1) / kMostTriangles;
    double sum = 0;
    double seen = 0;
    for (std::size_t i = 0; i < geometry.triangles.size(); i += step) {
        const glm::uvec3& triangle = geometry.triangles[i];
        const glm::vec3& a = geometry.positions[triangle.x];
        const glm::vec3 area =
            glm::cross(geometry.positions[triangle.y] - a, geometry.positions[triangle.z] - a) * 0.5F;
        double solid_angle = glm::dot(glm::dvec3(area), view.towards(glm::dvec3(a)));
        if (!(solid_angle > 0)) continue;
        if (!view.orthographic) {
            const glm::dvec3 away = glm::dvec3(a) - view.eye;
            solid_angle = std::min(solid_angle / glm::dot(away, away), 4.0);
        }
        std::array<glm::vec3, 3> mirrored;
        for (int k = 0; k < 3; ++k) {
            const glm::vec3 to_eye(view.towards(glm::dvec3(geometry.positions[triangle[k]])));
            const glm::vec3& normal = geometry.normals[triangle[k]];
            mirrored[static_cast<std::size_t>(k)] = 2 * glm::dot(normal, to_eye) * normal - to_eye;
        }
        double turned2 = 0;
        for (std::size_t k = 0; k < 3; ++k) {
            const glm::vec3 d = mirrored[k] - mirrored[(k + 1) % 3];
            turned2 = std::max(turned2, static_cast<double>(glm::dot(d, d)));
        }
        const auto range =
            std::ranges::upper_bound(geometry.ranges, std::size_t{triangle.x}, {}, &VertexRange::last);
        const double l = orders[static_cast<std::size_t>(range - geometry.ranges.begin())];
        const double missed = std::min(1.0, l * (l + 1) * turned2 / std::sqrt(120.0));
        sum += solid_angle * missed * missed;
        seen += solid_angle;
    }
    return seen > 0 ? kVarying * std::sqrt(sum / seen) : 0;
}

}  // namespace nicol
