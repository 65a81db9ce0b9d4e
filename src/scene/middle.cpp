// SPDX-License-Identifier: MIT
#include "scene/middle.hpp"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "geometry/box.hpp"
#include "geometry/largest_coordinate.hpp"

namespace nicol {
namespace {

constexpr int kSizes = 3;  // binary logarithm of the rounding in sizes of the instance

}  // namespace

std::size_t largest_instance(const Scene& scene) {
    const auto largest = std::ranges::max_element(
        scene.instances(), {}, [](const Instance& instance) { return instance.mesh->positions.size(); });
    return static_cast<std::size_t>(largest - scene.instances().begin());
}

glm::dvec3 middle_of(const Instance& instance) {
    Box box;
    box.add(*instance.mesh, instance.to_world);
    const auto& [low, high] = box;
    const double size = glm::distance(low, high) / 2;
    const double farthest = std::max(glm::length(low), glm::length(high));
    if (!(size > 0 && farthest < static_cast<double>(kLargestCoordinate))) return glm::dvec3(0.0);
    const double step = std::ldexp(1.0, std::ilogb(size) + kSizes);
    return step * glm::round((0.5 * low + 0.5 * high) / step);
}

glm::dmat4 from_middle(const glm::dvec3& middle) {
    glm::dmat4 shift(1.0);
    shift[3] = glm::dvec4(-middle, 1);
    return shift;
}

}  // namespace nicol
