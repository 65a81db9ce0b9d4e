// SPDX-License-Identifier: MIT
// Visibility of a refinement's points between vertices.
#pragma once

#include <cstddef>
#include <deque>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <memory>
#include <optional>
#include <span>

#include "geometry/ray_scene.hpp"
#include "visibility/agreeing_neighbours.hpp"
#include "visibility/bake.hpp"
#include "visibility/disturbed_rays.hpp"
#include "visibility/hidden_light.hpp"
#include "visibility/nearby_points.hpp"
#include "visibility/possible_blockers.hpp"
#include "visibility/refine.hpp"
#include "visibility/vertex_rays.hpp"

namespace nicol {

class PointTracer {
public:
    /// former: null, or an earlier refinement. All arguments must outlive the object.
    PointTracer(const BakeGeometry& geometry, const DirectionSet& directions, const FormerRefinement* former);

    [[nodiscard]] const RayScene& scene() const noexcept { return *rays_.blockers; }
    [[nodiscard]] const HiddenLight& light() const noexcept { return light_; }

    /// Point between two vertices.
    struct Point {
        glm::vec3 origin;   ///< origin of its rays
        glm::vec3 normal;   ///< unit
        std::size_t given;  ///< vertex before refinement of the object that the point belongs to
    };
    /// Sets row i of `seen`, whose bits must be 0, and `hides`, the HiddenLight. Takes from the former
    /// refinement what is the same there. around: the two ends of an edge so short that its middle sees what
    /// both see, but for a sample of rays that differ; or a point in the same pixel, and the ends of an edge
    /// of any length. Empty: all rays are traced. Calls may run side by side.
    RayCounts trace(const Point& at, std::span<const Seeing> around, std::size_t i, Visibility& seen,
                    glm::vec4& hides) const;

private:
    // Point of the former refinement that has the visibility of a point, but for its disturbed rays.
    struct Former {
        std::size_t point;
        const DisturbedRays* disturbed;
    };
    [[nodiscard]] std::optional<Former> find(const Point& at) const;

    const DirectionSet& directions_;
    const FormerRefinement* const former_;
    std::optional<DisturbedRays> disturbed_;  // set if there is a former refinement
    std::deque<DisturbedRays> beside_;        // of its shifted objects
    NearbyPoints nearby_;                     // its points, if there are shifted objects
    const BakeRays rays_;
    const std::shared_ptr<const PossibleBlockers> blockers_;
    HiddenLight light_;
};

}  // namespace nicol
