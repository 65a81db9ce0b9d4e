// SPDX-License-Identifier: MIT
// Places that photons of narrow lobes are aimed at.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "methods/linked_surfaces.hpp"
#include "polarization/stokes.hpp"
#include "shading/lobe_sample.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Balls around the receivers that links join with the surfaces of each range of a geometry.
class PhotonTargets {
public:
    PhotonTargets(const WorldGeometry& geometry, const LinkedSurfaces& surfaces);

    /// Returns the cone of a range's ball as a point of its surfaces sees it, in the point's frame. None: the
    /// ball is near, so that lobes meet it often enough, below the horizon or too far to have a solid angle,
    /// or it has no size.
    [[nodiscard]] std::optional<AimedCone> seen_from(std::size_t range, const glm::dvec3& position,
                                                     const Frame& frame) const;

private:
    struct Target {
        glm::dvec3 middle{0.0};
        double radius = 0;  // 0: there are no receivers, or they are at one place
    };
    std::vector<Target> targets_;  // [range]
};

}  // namespace nicol
