// SPDX-License-Identifier: MIT
// Light from an extracted light of an environment.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "light/extracted_light.hpp"
#include "shading/light_source.hpp"

namespace nicol {

/// Its places are those of a grid of u and v, found once, since finding one takes longer than reflecting it.
class ExtractedSource final : public LightSource {
public:
    /// `axes`: from the environment's to the points', a rotation; `scale`: times the light.
    ExtractedSource(std::shared_ptr<const ExtractedLight> extracted_light, const glm::dmat3& axes,
                    double scale);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return radius_; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    static constexpr std::size_t kAcross = 16;  // places of a row, and rows

    struct Sample {
        glm::vec3 towards;
        glm::vec3 x;
    };

    std::shared_ptr<const ExtractedLight> extracted_light_;
    glm::mat3 axes_;
    float scale_;
    float radius_;
    std::size_t components_;
    std::size_t channels_;
    std::vector<Sample> samples_;      // [row][column]
    std::vector<float> irradiance_;  // [row][column][channel][component]
};

}  // namespace nicol
