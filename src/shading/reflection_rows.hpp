// SPDX-License-Identifier: MIT
// Reflection towards a viewer as rows over the incident light in the world's axes.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <span>

#include "harmonics/light_layout.hpp"
#include "material/layer_weights.hpp"
#include "material/response_table.hpp"
#include "polarization/views.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// The linear function by which Shade reflects a light: one row per Stokes component. A row
/// serves any number of lights at its point. Immutable; threads share it.
class ReflectionRows {
public:
    /// tables: layout of the response tables. light: components of the incident light, none beyond those of
    /// the tables. components: number of leading components of reflected light, 1, 3 or 4.
    ReflectionRows(const LightLayout& tables, LightKind light, std::size_t components);

    [[nodiscard]] std::size_t components() const noexcept { return components_; }
    /// Returns the layout of the incident light.
    [[nodiscard]] const LightLayout& light() const noexcept { return light_; }

    /// Sets `out` to the rows of at most kLanes points, [point][component][number of the light], see
    /// VertexLight::row(). The dot products with light in the world's axes are the Stokes vectors towards the
    /// viewers, in their frame fields. layers, weights: of the material, as for Shade; no weights: the only
    /// layer's weight is 1.
    void run(std::span<const ResponseTable* const> layers, std::span<const LayerWeights> weights,
             std::size_t channel, const Views& views, std::span<const glm::vec3> positions,
             std::span<const glm::vec3> normals, VertexLight& out) const;

private:
    LightLayout tables_;
    LightLayout light_;
    std::size_t components_;
    FrameRotation rotation_;
};

}  // namespace nicol
