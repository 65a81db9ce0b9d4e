// SPDX-License-Identifier: MIT
#include "shading/ray_spread.hpp"

#include <cmath>
#include <glm/geometric.hpp>

#include "polarization/lane_points.hpp"

namespace nicol {
namespace {

glm::dvec3 vector(const Vector3<double>& v) {
    return {v.x, v.y, v.z};
}

}  // namespace

void RaySpread::meet(const glm::dvec3& direction, double distance, const glm::dvec3& facet) {
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = vector(moved_to(components(direction), distance, components(facet),
                                    components(directions[i]), components(places[i])));
}

void RaySpread::reflect(const glm::dvec3& direction, const glm::dvec3& normal,
                        const std::array<glm::dvec3, 2>& bends) {
    for (std::size_t i = 0; i < directions.size(); ++i)
        directions[i] = vector(reflected_change(components(direction), components(normal),
                                                components(bends[i]), components(directions[i])));
}

void RaySpread::refract(const glm::dvec3& direction, const glm::dvec3& normal,
                        const std::array<glm::dvec3, 2>& bends, double eta) {
    const double cosine = -glm::dot(direction, normal);
    const double square = eta * eta - 1 + cosine * cosine;
    if (!(square > 0)) return;
    for (std::size_t i = 0; i < directions.size(); ++i)
        directions[i] =
            vector(refracted_change(components(direction), components(normal), components(bends[i]), eta,
                                    std::sqrt(square), components(directions[i])));
}

double RaySpread::variance() const {
    // A sample is a square, whose variance along a side is a twelfth of the side's square.
    return (glm::dot(directions[0], directions[0]) + glm::dot(directions[1], directions[1])) / 24;
}

}  // namespace nicol
