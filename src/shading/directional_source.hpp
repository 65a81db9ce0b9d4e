// SPDX-License-Identifier: MIT
// Light from a direction, or a disc of the sky.
#pragma once

#include "shading/light_source.hpp"

namespace nicol {

class DirectionalSource final : public LightSource {
public:
    /// `axes`: of the light, a rotation into the points' axes.
    DirectionalSource(const SmallLight& light, const glm::dmat3& axes);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return radius_; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    SourceColor color_;
    float radius_;
    float height_;   // 1 - cos(radius)
    float density_;  // irradiance of a place times the solid angle, over that of the whole disc
    glm::vec3 towards_, right_, up_;
};

}  // namespace nicol
