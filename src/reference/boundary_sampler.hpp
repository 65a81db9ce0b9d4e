// SPDX-License-Identifier: MIT
// Sampler of directions towards the light at a rough boundary that transmits light.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "material/dielectric.hpp"

namespace nicol {

/// Directions that the visible facets of a rough boundary reflect or transmit to a viewer on any side. All
/// directions are in the surface's frame, whose z is the normal of the front.
class BoundarySampler {
public:
    /// Keeps a reference. towards_viewer: unit vector.
    BoundarySampler(const SmoothBoundary& boundary, const glm::dvec3& towards_viewer);

    /// Returns the probability of sample_transmitted() as against a sample of the reflection.
    [[nodiscard]] double transmitted_share() const noexcept { return transmitted_share_; }

    /// Samples a unit direction of light that is transmitted. point: in [0, 1)^2. A direction on the viewer's
    /// side carries no light.
    [[nodiscard]] glm::dvec3 sample_transmitted(const glm::dvec2& point) const;
    /// Returns the density of sample_transmitted() per steradian.
    [[nodiscard]] double transmitted_pdf(const glm::dvec3& towards_light) const;

    /// Samples a unit direction of light that is reflected. A direction on the other side carries no light.
    [[nodiscard]] glm::dvec3 sample_reflected(const glm::dvec2& point) const;
    /// Returns the density of sample_reflected() per steradian.
    [[nodiscard]] double reflected_pdf(const glm::dvec3& towards_light) const;

private:
    /// Returns the normal of a visible facet, on the viewer's side.
    [[nodiscard]] glm::dvec3 facet(const glm::dvec2& point) const;
    /// Returns the density of facet() per steradian.
    [[nodiscard]] double facet_pdf(const glm::dvec3& facet) const;

    const SmoothBoundary& boundary_;
    glm::dvec3 viewer_;
    double side_;  ///< 1: the viewer is in front; -1: behind
    double eta_;   ///< index of the far side relative to the viewer's
    double transmitted_share_;
};

}  // namespace nicol
