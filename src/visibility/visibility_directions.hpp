// SPDX-License-Identifier: MIT
// Directions in which visibility is sampled, equal at all vertices.
#pragma once

#include <cstddef>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "geometry/ray_scene.hpp"

namespace nicol {

/// Unit directions towards the light, in the world's axes unless rotated. They are spread evenly over the
/// sphere (a spherical Fibonacci lattice, one direction per stratum) and sorted so that neighbours in the
/// list are neighbours on the sphere. Immutable.
class DirectionSet {
public:
    static constexpr int kDefault = 2048;
    static constexpr int kFewest = 256;
    static constexpr int kMost = 65536;
    /// Highest order of harmonics that the weights integrate exactly up to rounding: 16, or half the root of
    /// the count if that is less.
    static constexpr int kExactOrder = 16;

    /// Throws Error(invalid_argument) for a count outside kFewest..kMost.
    explicit DirectionSet(int count = kDefault);

    /// Returns these directions and weights about other axes: the columns of a rotation.
    [[nodiscard]] DirectionSet rotated(const glm::dmat3& axes) const;

    [[nodiscard]] std::size_t size() const noexcept { return directions_.size(); }
    [[nodiscard]] std::span<const glm::vec3> directions() const noexcept { return directions_; }
    /// Returns the solid angles of the directions; they are positive and their sum is 4 pi.
    [[nodiscard]] std::span<const float> weights() const noexcept { return weights_; }
    /// Returns the directions in bundles of RayBundle::kRays; the last bundle is filled up with the last
    /// direction.
    [[nodiscard]] std::span<const RayBundle> bundles() const noexcept { return bundles_; }

private:
    void fill_bundles();

    std::vector<glm::vec3> directions_;
    std::vector<float> weights_;
    std::vector<RayBundle> bundles_;
};

}  // namespace nicol
