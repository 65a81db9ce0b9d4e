// SPDX-License-Identifier: MIT
// shade of the dense method: outgoing coefficients at the view direction.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "polarization/viewpoint.hpp"
#include "transfer/dense.hpp"

namespace nicol {

/// The value of an OutgoingLight towards a viewpoint, in the camera's frame field. The harmonics come from a
/// table over the zenith angle that misses less than 1e-6 of their largest value up to order 16.
class OutgoingShade {
public:
    explicit OutgoingShade(const LightLayout& layout);

    /// For every vertex first <= v < last with visible[v] != 0, writes channel c's Stokes vector to
    /// out[c][v]; others are left alone. `light` of one channel serves all; its vertices are those of
    /// `positions`. Calls for different vertices may run side by side.
    void run(const OutgoingLight& light, const Viewpoint& view, std::span<const glm::vec3> positions,
             std::span<const glm::vec3> normals, std::span<const std::uint8_t> visible, std::size_t first,
             std::size_t last, std::span<const std::span<glm::vec4>> out) const;

    /// Entries first <= j < last of the layout, of one part (0: s0, 1: s1 and s2, 2: s3) and one frequency,
    /// sign * degree.
    struct Run {
        std::size_t part;
        std::size_t degree;
        float sign;
        std::size_t first;
        std::size_t last;
    };

    /// [angle from 0 to pi/2][entry of the layout]
    [[nodiscard]] std::span<const float> harmonics() const noexcept { return table_; }

private:
    static constexpr int kAngles = 4097;

    LightLayout layout_;
    std::vector<Run> runs_;
    std::vector<float> table_;  // [angle][j]
};

}  // namespace nicol
