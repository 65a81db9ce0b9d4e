// SPDX-License-Identifier: MIT
// Which directions of a bake may meet what lies in a sphere.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "visibility/bake.hpp"

namespace nicol {

/// A cone around each of a set's bundles of directions.
class BundleCones {
public:
    explicit BundleCones(const DirectionSet& directions);

    /// Sets disturbed[b] where a ray from `origin` in a direction of bundle b may meet the ball; others are
    /// left alone. For directions above the plane of the unit normal it is conservative: it may set too many,
    /// never too few.
    void mark(const glm::vec3& origin, const glm::vec3& normal, const Ball& ball,
              std::span<std::uint8_t> disturbed) const;

private:
    // Unit axes, and cosines and sines of half the opening angle.
    std::vector<float> x_, y_, z_, cosine_, sine_;
};

}  // namespace nicol
