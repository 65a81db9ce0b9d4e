// SPDX-License-Identifier: MIT
// The shade step: light in the vertices' frames times the material's response, at the view direction.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "harmonics/light_layout.hpp"
#include "material/response_table.hpp"
#include "polarization/views.hpp"
#include "shading/lane_response.hpp"
#include "shading/layer_rows.hpp"
#include "specular/mixture_rows.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Evaluator of Stokes vectors towards a viewpoint, in the camera's frame field.
class Shade {
public:
    /// Computes the Stokes components that the material produces, but at least the first `least` and at most
    /// the first `most` components (1, 3 or 4). The other components are 0.
    explicit Shade(LightLayout layout, std::size_t least = 1, std::size_t most = 4);

    /// Writes channel c's Stokes vector to out[c][v] for every vertex `first` <= v < `last` with visible[v]
    /// != 0; leaves other vectors unchanged. A light of one channel serves all. Sixteen vertices that share a
    /// block of `light` take about as long as one. Calls for different vertices may run side by side.
    void run(const ResponseTable& response, const VertexLight& light, const Views& views,
             std::span<const glm::vec3> positions, std::span<const glm::vec3> normals,
             std::span<const std::uint8_t> visible, std::size_t first, std::size_t last,
             std::span<const std::span<glm::vec4>> out) const;

    /// Writes the Stokes vectors of a material's layers, each times weights, for all positions. layers:
    /// [layer]; weights: [block of sixteen][layer]. The rows are summed before the dot product with light, so
    /// that layers cost little.
    void run(std::span<const ResponseTable* const> layers, std::span<const LayerWeights> weights,
             const VertexLight& light, const Views& views, std::span<const glm::vec3> positions,
             std::span<const glm::vec3> normals, std::span<const std::span<glm::vec4>> out) const;

    [[nodiscard]] const LightLayout& layout() const noexcept { return layout_; }

private:
    ComponentLimits components_;
    LightLayout layout_;
};

}  // namespace nicol
