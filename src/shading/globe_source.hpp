// SPDX-License-Identifier: MIT
// Light from a sphere that shines.
#pragma once

#include <optional>

#include "shading/light_source.hpp"

namespace nicol {

struct Globe {
    glm::dvec3 centre;
    double radius;        ///< of the sphere with the surface's area
    double outer_radius;  ///< of one that holds the surface
};
/// Of a closed surface that faces outwards and is nearly a sphere.
[[nodiscard]] std::optional<Globe> globe_of(const std::vector<std::array<glm::vec3, 3>>& triangles);

/// Its places are uniform over the solid angle that a point sees of it, so that none is wasted on its far
/// side.
class GlobeSource final : public LightSource {
public:
    /// `axis`: see ShiningSurface.
    GlobeSource(const Globe& globe, const Emission& emission, const glm::dvec3& axis);

    [[nodiscard]] float angular_radius(const glm::vec3& from) const noexcept override;
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    SourceColor color_;
    glm::vec3 centre_;
    float radius_;
    float outer_radius_;  // where rays to the light end, so that its own triangles do not hide it
};

}  // namespace nicol
