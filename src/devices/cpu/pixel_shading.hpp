// SPDX-License-Identifier: MIT
// shade at pixels on threads.
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

/// A material that varies.
struct TexturedSurface {
    std::vector<const ResponseTable*> responses;  ///< of the layers
    std::optional<HighOrderLayers> high_orders;
};

/// What the pixels of a range are shaded by.
struct PixelSurface {
    const Shade* shade;
    const TexturedSurface* textures;  ///< of a material that varies, instead of the next; or null
    const ResponseTable* response;
    const HighOrder* high_orders;   ///< or null
    const VertexLight* light;       ///< as rows
    std::size_t first_row;          ///< the vertex that its first row is of
    const FrameRotation* rotation;  ///< of the light
    const Relight* unoccluded;      ///< for pixels between unoccluded vertices, or null
};

/// What it took to shade pixels.
struct PixelCounts {
    std::size_t shaded = 0;    ///< Stokes vectors, times channels
    std::uint64_t rays = 0;    ///< to local lights
    double light_seconds = 0;  ///< of one thread, for local lights
};

/// Shades the pixels of an image that show a surface. Calls for different pixels may run side by side.
class PixelShading {
public:
    /// `surfaces`: of the geometry's ranges. `fractions`: of the vertices' lobes of high orders, or empty.
    PixelShading(const PixelInput& input, std::span<const PixelSurface> surfaces,
                 std::span<const glm::vec2> fractions);

    /// For first <= pixel < last writes to out[c][pixel] the mean of channel c's Stokes vectors over the
    /// samples, those without a surface showing the background.
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
