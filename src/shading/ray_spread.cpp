// SPDX-License-Identifier: MIT
#include "shading/ray_spread.hpp"

#include <cmath>
#include <glm/geometric.hpp>

namespace nicol {

void RaySpread::meet(const glm::dvec3& direction, double distance, const glm::dvec3& facet) {
    const double across = glm::dot(direction, facet);
    for (std::size_t i = 0; i < places.size(); ++i) {
        places[i] += distance * directions[i];
        places[i] -= glm::dot(places[i], facet) / across * direction;
    }
}

void RaySpread::reflect(const glm::dvec3& direction, const glm::dvec3& normal,
                        const std::array<glm::dvec3, 2>& bends) {
    const double along = glm::dot(direction, normal);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double change = glm::dot(directions[i], normal) + glm::dot(direction, bends[i]);
        directions[i] -= 2.0 * (along * bends[i] + change * normal);
    }
}

void RaySpread::refract(const glm::dvec3& direction, const glm::dvec3& normal,
                        const std::array<glm::dvec3, 2>& bends, double eta) {
    // The refracted direction is (direction + (cosine - root) normal) / eta.
    const double cosine = -glm::dot(direction, normal);
    const double square = eta * eta - 1 + cosine * cosine;
    if (!(square > 0)) return;
    const double root = std::sqrt(square);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const double change = -glm::dot(directions[i], normal) - glm::dot(direction, bends[i]);
        directions[i] =
            (directions[i] + (cosine - root) * bends[i] + change * (1 - cosine / root) * normal) / eta;
    }
}

double RaySpread::variance() const {
    // A sample is a square, whose variance along a side is a twelfth of the side's square.
    return (glm::dot(directions[0], directions[0]) + glm::dot(directions[1], directions[1])) / 24;
}

}  // namespace nicol
