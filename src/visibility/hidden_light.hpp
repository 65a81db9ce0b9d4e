// SPDX-License-Identifier: MIT
// Light of a white environment that is hidden from a vertex.
#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <vector>

#include "simd/lanes.hpp"
#include "visibility/ray_cones.hpp"
#include "visibility/visibility.hpp"

namespace nicol {

/// Sums over the hidden directions of a vertex.
class HiddenLight {
public:
    /// directions: must outlive the object.
    explicit HiddenLight(const DirectionSet& directions);

    /// Returns the hidden irradiance and its first moment (x, y, z), relative to the irradiance at an
    /// unoccluded vertex.
    [[nodiscard]] glm::vec4 at(const Visibility& visibility, std::size_t vertex,
                               const glm::vec3& unit_normal) const;

    /// Returns the magnitude of a difference of two results: of the irradiance or of the moment, whichever is
    /// larger.
    [[nodiscard]] static double magnitude(const glm::vec4& difference);

private:
    const DirectionSet& directions_;
    RayCones cones_;
    std::vector<Lanes> weights_;  // weights of the directions over pi, in bundles; 0 past the last direction
};

}  // namespace nicol
