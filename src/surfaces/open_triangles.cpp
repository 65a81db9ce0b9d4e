// SPDX-License-Identifier: MIT
#include "surfaces/open_triangles.hpp"

#include <algorithm>
#include <array>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "geometry/ray_scene.hpp"

namespace nicol {
namespace {

constexpr std::size_t kChildren = 8;  // positions in a box of the first level, boxes in another

}  // namespace

OpenTriangles::OpenTriangles(std::span<const glm::vec3> positions) : positions_(positions) {
    const auto add_level = [this](std::size_t children, const auto& box_of) {
        std::vector<Box> boxes;
        boxes.reserve((children + kChildren - 1) / kChildren);
        for (std::size_t first = 0; first < children; first += kChildren) {
            Box& around = boxes.emplace_back(box_of(first));
            for (std::size_t child = first + 1; child < std::min(first + kChildren, children); ++child) {
                const Box own = box_of(child);
                around = {glm::min(around.lower, own.lower), glm::max(around.upper, own.upper)};
            }
        }
        levels_.push_back(std::move(boxes));
    };
    if (positions.empty()) return;
    add_level(positions.size(), [&](std::size_t i) { return Box{positions[i], positions[i]}; });
    while (levels_.back().size() > 1) {
        const std::vector<Box> below = levels_.back();
        add_level(below.size(), [&](std::size_t i) { return below[i]; });
    }
}

bool OpenTriangles::open(const glm::uvec3& corners) const {
    const std::array points{positions_[corners.x], positions_[corners.y], positions_[corners.z]};
    const glm::dvec3 first(points[0]);
    const glm::dvec3 across = glm::cross(glm::dvec3(points[1]) - first, glm::dvec3(points[2]) - first);
    const double area = glm::length(across);
    if (!(area > 0)) return false;
    const glm::dvec3 normal = across / area;
    // Rays start farther above the triangle than this, so that rounding lifts nothing into their way.
    const double height = glm::dot(normal, first) + 0.5 * ray_offset(points);
    return !any_above({normal, height}, levels_.size() - 1, 0);
}

bool OpenTriangles::any_above(const Plane& plane, std::size_t level, std::size_t box) const {
    const Box& of = levels_[level][box];
    const glm::dvec3 highest =
        glm::max(plane.normal * glm::dvec3(of.lower), plane.normal * glm::dvec3(of.upper));
    if (highest.x + highest.y + highest.z <= plane.height) return false;
    const std::size_t children = level == 0 ? positions_.size() : levels_[level - 1].size();
    const std::size_t last = std::min((box + 1) * kChildren, children);
    for (std::size_t child = box * kChildren; child < last; ++child) {
        const bool above = level == 0 ? glm::dot(plane.normal, glm::dvec3(positions_[child])) > plane.height
                                      : any_above(plane, level - 1, child);
        if (above) return true;
    }
    return false;
}

}  // namespace nicol
