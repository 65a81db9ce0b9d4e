// SPDX-License-Identifier: MIT
// How a vertex is seen: what looking up a table at the view direction needs.
#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "nicol/light_layout.hpp"
#include "transfer/viewpoint.hpp"

namespace nicol {

/// Holds work space; one object a thread.
class VertexView {
public:
    explicit VertexView(const LightLayout& layout);

    /// A normal that faces away is treated as seen at 90 degrees: the triangle may face the camera all the
    /// same.
    void look(const Viewpoint& view, const glm::vec3& position, const glm::vec3& normal);

    /// Zenith angle of the viewer as a position in a table of `angles` from 0 to pi/2: the element below, and
    /// the weight of the one above.
    struct TablePosition {
        int angle;
        float fraction;
    };
    [[nodiscard]] TablePosition position_in(int angles) const;

    /// Real and imaginary parts of exp(i k_j phi), phi the azimuth of the viewer, for each entry of the
    /// layout.
    [[nodiscard]] std::span<const float> cosine() const noexcept { return cosine_; }
    [[nodiscard]] std::span<const float> sine() const noexcept { return sine_; }

    /// (s1, s2) from the theta-phi frame about the normal to the camera's frame field.
    [[nodiscard]] glm::vec2 in_camera_frame(float s1, float s2) const {
        return {cos2_ * s1 + sin2_ * s2, cos2_ * s2 - sin2_ * s1};
    }

private:
    std::vector<int> frequency_;
    std::vector<float> powers_cos_;
    std::vector<float> powers_sin_;
    std::vector<float> cosine_;
    std::vector<float> sine_;
    double zenith_ = 0;
    float cos2_ = 1;
    float sin2_ = 0;
};

}  // namespace nicol
