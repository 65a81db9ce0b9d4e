// SPDX-License-Identifier: MIT
// Light source for an extracted light of an environment.
#pragma once

#include <glm/mat3x3.hpp>
#include <memory>
#include <vector>

#include "light/extracted_light.hpp"
#include "shading/light_source.hpp"

namespace nicol {

/// Extracted light with a fixed grid of light samples over u and v. The samples are computed once, because
/// computing a sample takes longer than reflecting it.
class ExtractedSource final : public LightSource {
public:
    /// Takes `axes`, a rotation from the environment's axes to the points', and `scale`, a factor of the
    /// light.
    ExtractedSource(std::shared_ptr<const ExtractedLight> extracted_light, const glm::dmat3& axes,
                    double scale);

    [[nodiscard]] float angular_radius(const glm::vec3& /*from*/) const noexcept override { return radius_; }
    [[nodiscard]] float brightness(const glm::vec3& /*from*/) const noexcept override { return brightness_; }
    void sample(const LaneVectors& points, const Lanes& u, const Lanes& v, LaneLight& out) const override;
    void intersect(const LaneVectors& points, const LaneVectors& directions, LaneLight& out) const override;

private:
    static constexpr std::size_t kAcross = 16;  // samples per row, and number of rows

    struct Sample {
        glm::vec3 towards;
        glm::vec3 x;
    };

    std::shared_ptr<const ExtractedLight> extracted_light_;
    glm::mat3 axes_;
    float scale_;
    float radius_;
    float brightness_ = 0;  // of the brightest channel
    std::size_t components_;
    std::size_t channels_;
    std::vector<Sample> samples_;    // [row][column]
    std::vector<float> irradiance_;  // [row][column][channel][component]
};

}  // namespace nicol
