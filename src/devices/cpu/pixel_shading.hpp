// SPDX-License-Identifier: MIT
// Shading at pixels on threads.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "devices/pixel_lights.hpp"
#include "material/response_table.hpp"
#include "methods/executor.hpp"
#include "shading/background.hpp"
#include "shading/shade.hpp"
#include "specular/high_order.hpp"
#include "specular/high_order_layers.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Data for shading a textured material.
struct TexturedSurface {
    std::vector<const ResponseTable*> responses;  ///< response tables of the layers
    std::optional<HighOrderLayers> high_orders;
};

/// Data for shading the pixels of one range.
struct PixelSurface {
    const Shade* shade;
    const TexturedSurface* textures;  ///< textured material, in place of response and high_orders; or null
    const ResponseTable* response;
    const HighOrder* high_orders;   ///< high orders of the material, or null
    const VertexLight* light;       ///< light as rows
    std::size_t first_row;          ///< index of the vertex of the light's first row
    const FrameRotation* rotation;  ///< rotation of the light
    const Relight* unoccluded;      ///< relight for pixels between unoccluded vertices, or null
};

/// Counts and times of shading pixels.
struct PixelCounts {
    std::size_t shaded = 0;  ///< number of shaded points
    LightingTally lighting{};
    double light_seconds = 0;  ///< time of one thread for local lights, in seconds
};

/// Shading of the pixels of an image that show a surface. Calls for different pixels may run in parallel.
class PixelShading {
public:
    /// surfaces: one per range of the geometry. fractions: visible fractions of the vertices' lobes of high
    /// orders, or empty.
    PixelShading(const PixelInput& input, std::span<const PixelSurface> surfaces,
                 std::span<const glm::vec2> fractions);

    /// Writes to out[c][pixel], for first <= pixel < last, the mean of channel c's Stokes vectors over the
    /// samples. Samples without a surface show the background.
    PixelCounts run(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out) const;

private:
    struct Work;

    void shade(const PixelBatch& batch, Work& work, std::span<const std::span<glm::vec4>> out,
               PixelCounts& counts) const;
    void add_local_lights(const PixelBatch& batch, std::span<const std::span<glm::vec4>> stokes,
                          PixelCounts& counts) const;
    void find_light(const PixelSurface& surface, const PixelBatch& batch, Work& work) const;
    void find_fractions(const PixelBatch& batch, Work& work) const;
    [[nodiscard]] PixelRays rays() const;

    const PixelInput& input_;
    std::span<const PixelSurface> surfaces_;
    std::span<const glm::vec2> fractions_;
    std::optional<PixelLights> local_lights_;
};

}  // namespace nicol
