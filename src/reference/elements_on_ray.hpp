// SPDX-License-Identifier: MIT
// What a scene's polarization elements make of the light that reaches the camera along a ray.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "polarization/element.hpp"

namespace nicol {

/// Immutable; threads share it.
class ElementsOnRay {
public:
    /// In the world.
    explicit ElementsOnRay(std::span<const PolarizationElement> elements);

    [[nodiscard]] bool empty() const noexcept { return elements_.empty(); }

    /// The product of the Mueller matrices of the elements between ray.nearest and ray.farthest, the nearest
    /// to its origin acting last, for light in the frame `received`, whose z is -ray.direction. Nothing where
    /// there are no elements.
    [[nodiscard]] std::optional<Mueller> mueller(const Ray& ray, const Frame& received) const;

private:
    std::vector<PlacedElement> elements_;
};

}  // namespace nicol
