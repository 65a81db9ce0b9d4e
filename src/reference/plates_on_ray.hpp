// SPDX-License-Identifier: MIT
// What a scene's polarizing plates make of the light that reaches the camera along a ray.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"
#include "polarization/plate.hpp"

namespace nicol {

/// Immutable; threads share it.
class PlatesOnRay {
public:
    /// In the world.
    explicit PlatesOnRay(std::span<const PolarizingPlate> plates);

    [[nodiscard]] bool empty() const noexcept { return plates_.empty(); }

    /// The product of the Mueller matrices of the plates between ray.nearest and ray.farthest, the nearest to
    /// its origin acting last, for light in the frame `received`, whose z is -ray.direction. Nothing where
    /// there are no plates.
    [[nodiscard]] std::optional<Mueller> mueller(const Ray& ray, const Frame& received) const;

private:
    std::vector<PlacedPlate> plates_;
};

}  // namespace nicol
