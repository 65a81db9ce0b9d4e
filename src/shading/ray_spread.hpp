// SPDX-License-Identifier: MIT
// Rays beside a ray: how its start and direction change across a pixel (Igehy, Tracing Ray Differentials,
// 1999).
#pragma once

#include <array>
#include <glm/vec3.hpp>

#include "polarization/view_geometry.hpp"

namespace nicol {

// The changes of one neighbour of a ray, written for single numbers and for lanes. ray: unit direction.

/// Returns the neighbour's start, moved to a surface that the ray meets. change: that of the direction.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> moved_to(const Vector3<Number>& ray, const Number& distance,
                                                       const Vector3<Number>& facet,
                                                       const Vector3<Number>& change,
                                                       const Vector3<Number>& place) {
    Number across, rise;
    dot(ray, facet, across);
    const Vector3<Number> met = minus_scaled(place, Number(-distance), change);
    dot(met, facet, rise);
    return minus_scaled(met, Number(rise / across), ray);
}

/// Returns the change of the direction after a mirror. normal: unit normal on the ray's side. bend: the
/// change of the normal between the places of both rays.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> reflected_change(const Vector3<Number>& ray,
                                                               const Vector3<Number>& normal,
                                                               const Vector3<Number>& bend,
                                                               const Vector3<Number>& change) {
    Number along, by_normal, by_bend;
    dot(ray, normal, along);
    dot(change, normal, by_normal);
    dot(ray, bend, by_bend);
    return minus_scaled(minus_scaled(change, Number(2.0 * along), bend), Number(2.0 * (by_normal + by_bend)),
                        normal);
}

/// Returns the change of the direction after refraction. root: eta times the cosine of refraction, positive.
template <class Number>
[[gnu::always_inline]] inline Vector3<Number> refracted_change(const Vector3<Number>& ray,
                                                               const Vector3<Number>& normal,
                                                               const Vector3<Number>& bend, const Number& eta,
                                                               const Number& root,
                                                               const Vector3<Number>& change) {
    // The refracted direction is (ray + (cosine - root) normal) / eta.
    Number along, by_normal, by_bend;
    dot(ray, normal, along);
    dot(change, normal, by_normal);
    dot(ray, bend, by_bend);
    const Number cosine = -along;
    const Number by_cosine = (by_normal + by_bend) * (1.0 - cosine / root);
    const Vector3<Number> sum =
        minus_scaled(minus_scaled(change, Number(root - cosine), bend), by_cosine, normal);
    return {sum.x / eta, sum.y / eta, sum.z / eta};
}

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
