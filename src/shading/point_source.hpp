// SPDX-License-Identifier: MIT
// Light from a place without a size: a point, a spot or a projector.
#pragma once

#include "shading/light_source.hpp"

namespace nicol {

class PointSource final : public LightSource {
public:
    /// `to_axes`: from the light's own axes to the points', a rotation and a shift.
    PointSource(const SmallLight& light, const glm::dmat4& to_axes);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return 0; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    // Multiplies `factor` by how bright the light is in directions in its own axes, and finds where they meet
    // its texture.
    void aim(const LaneVectors& directions, Lanes& factor, TexturePoints& at, LaneLight& out) const;

    SmallLight light_;
    SourceColor color_;
    glm::vec3 place_;
    glm::mat3 axes_;  // the light's own
};

}  // namespace nicol
