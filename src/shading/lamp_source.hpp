// SPDX-License-Identifier: MIT
// Light from a lamp of an environment.
#pragma once

#include <glm/mat3x3.hpp>

#include "light/lamp.hpp"
#include "shading/light_source.hpp"

namespace nicol {

class LampSource final : public LightSource {
public:
    /// `axes`: from the environment's to the points', a rotation; `scale`: times the light.
    LampSource(std::shared_ptr<const Lamp> lamp, const glm::dmat3& axes, double scale);

    [[nodiscard]] bool has_size() const noexcept override { return true; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;

private:
    std::shared_ptr<const Lamp> lamp_;
    glm::mat3 axes_;
    float scale_;
};

}  // namespace nicol
