// SPDX-License-Identifier: MIT
// Rays of a bake that lie in cones.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/visibility_directions.hpp"

namespace nicol {

/// Finds the directions of a bake in cones. Bits are by bundle; bit i is that of the bundle's direction i.
class RayCones {
public:
    /// directions: must outlive the object.
    explicit RayCones(const DirectionSet& directions);

    /// Adds the directions at most the angle with this sine, below a right angle, away from a unit vector.
    /// May add a few more.
    void add(const glm::vec3& axis, float sine, std::span<std::uint16_t> bits) const;
    /// Adds direction number i and the directions beside it, about eight.
    void add_beside(std::size_t i, std::span<std::uint16_t> bits) const;
    /// Sets a number for each bundle: 0 only if all its directions are below the plane of a unit normal, else
    /// 1.
    void find_above(const glm::vec3& normal, std::span<std::uint8_t> above) const;
    [[nodiscard]] std::size_t bundles() const noexcept { return x_.size(); }

private:
    void add_bundle(const RayBundle& bundle);

    const DirectionSet& directions_;
    // Cones around the bundles: unit axes, and cosines and sines of half their opening angles.
    std::vector<float> x_, y_, z_, cosine_, sine_;
    float beside_;  // sine of the angle between a direction and the farthest beside it
};

}  // namespace nicol
