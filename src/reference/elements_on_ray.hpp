// SPDX-License-Identifier: MIT
// Effect of a scene's polarization elements on the light that reaches the camera along a ray.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "polarization/element.hpp"

namespace nicol {

/// Polarization elements along rays. Immutable; threads share it.
class ElementsOnRay {
public:
    ElementsOnRay() = default;
    /// elements: polarization elements in the world. from_world: transform to the rays' coordinates.
    explicit ElementsOnRay(std::span<const PolarizationElement> elements,
                           const glm::dmat4& from_world = glm::dmat4(1.0));

    [[nodiscard]] bool empty() const noexcept { return elements_.empty(); }

    /// Returns the product of the Mueller matrices of the elements between ray.nearest and ray.farthest, the
    /// nearest to the ray's origin acting last, for light in the frame `received`, whose z is -ray.direction.
    /// None if there are no elements.
    [[nodiscard]] std::optional<Mueller> mueller(const Ray& ray, const Frame& received) const;

private:
    std::vector<PlacedElement> elements_;
};

}  // namespace nicol
