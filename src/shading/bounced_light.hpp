// SPDX-License-Identifier: MIT
// Light that surfaces reflect to each other, in single directions.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "harmonics/light_layout.hpp"
#include "light/lane_light.hpp"
#include "shading/lane_surface.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// s0 of what other surfaces look like from sixteen points: their light over their coverage of directions.
class BouncedLight {
public:
    /// rows: light of surfaces at vertices and, as the last channel, their coverage, in the points' axes
    /// after VertexLight::to_rows(). The object keeps a reference to them.
    BouncedLight(const LightLayout& layout, const VertexLight& rows);

    /// Interpolates the light of the corners of triangles: at most kLanes.
    void take(std::span<const Corners> triangles, const std::array<Lanes, 3>& weights);
    /// Adds the radiance of surfaces in the directions light.towards, times factors, to s0 of
    /// light.irradiance, which gets a channel for each one of the rows. Negative radiance counts as 0.
    void add_to(const Lanes& factors, LaneLight& light) const;

private:
    const VertexLight& rows_;
    int order_;
    std::vector<std::size_t> harmonics_;  // psh_index() of the numbers of s0
    std::size_t size_;                    // of a channel in a row
    std::vector<Lanes> light_;            // [channel and coverage][number of s0]
};

}  // namespace nicol
