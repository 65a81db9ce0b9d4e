// SPDX-License-Identifier: MIT
// Visibility of a refinement's points between vertices.
#pragma once

#include <cstddef>
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

    /// Sets row i of `seen`, whose bits must be 0, and `hides`, the HiddenLight. Takes from the former
    /// refinement what is the same there. ends: the ends of an edge so short that its middle sees what both
    /// see, but for a sample of rays that differ; empty: all rays are traced. Calls may run side by side.
    RayCounts trace(const glm::vec3& origin, const glm::vec3& normal, std::span<const Seeing> ends,
                    std::size_t i, Visibility& seen, glm::vec4& hides) const;

private:
    const DirectionSet& directions_;
    const FormerRefinement* const former_;
    std::optional<DisturbedRays> disturbed_;  // set if there is a former refinement
    const BakeRays rays_;
    PossibleBlockers blockers_;
    HiddenLight light_;
};

}  // namespace nicol
