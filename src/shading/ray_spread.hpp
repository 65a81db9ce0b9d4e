// SPDX-License-Identifier: MIT
// Rays beside a ray: how its start and direction change across a pixel (Igehy, Tracing Ray Differentials,
// 1999).
#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace nicol {

/// Changes of a ray across a sample of a pixel, to the right and down, to first order.
struct RaySpread {
    std::array<glm::dvec3, 2> places{glm::dvec3(0.0), glm::dvec3(0.0)};
    std::array<glm::dvec3, 2> directions{glm::dvec3(0.0), glm::dvec3(0.0)};

    /// Moves the places to a surface that the ray meets. direction: of the ray, unit. facet: unit normal of
    /// the surface, not orthogonal to the ray.
    void meet(const glm::dvec3& direction, double distance, const glm::dvec3& facet);
    /// Changes the directions as a mirror does. normal: unit shading normal on the ray's side. bends: its
    /// changes along `places`.
    void reflect(const glm::dvec3& direction, const glm::dvec3& normal,
                 const std::array<glm::dvec3, 2>& bends);
    /// Changes the directions as a boundary does that refracts. eta: index of the far side relative to the
    /// ray's. Under total reflection they stay the same.
    void refract(const glm::dvec3& direction, const glm::dvec3& normal,
                 const std::array<glm::dvec3, 2>& bends, double eta);

    /// Returns the mean variance of the directions, along an axis, in square radians.
    [[nodiscard]] double variance() const;
};

}  // namespace nicol
