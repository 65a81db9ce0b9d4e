// SPDX-License-Identifier: MIT
// shade at pixels on threads.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "material/response_table.hpp"
#include "render/cpu/pixel_lights.hpp"
#include "render/executor.hpp"
#include "shading/background.hpp"
#include "shading/shade.hpp"
#include "specular/high_order.hpp"
#include "specular/high_order_layers.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// A material that varies.
struct TexturedSurface {
    const SpatialVariation* variation;
    bool back;                                    ///< of a two-sided instance
    std::vector<const ResponseTable*> responses;  ///< of the layers
    std::optional<HighOrderLayers> high_orders;
};

/// What the pixels of some of the geometry's vertices are shaded by.
struct PixelSurface {
    std::size_t first;  ///< vertex
    std::size_t last;
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
    std::uint64_t rays = 0;    ///< to small lights
    double light_seconds = 0;  ///< of one thread, for small lights
};

/// Shades the pixels of an image that show a surface. Calls for different pixels may run side by side.
class PixelShading {
public:
    /// `surfaces`: by vertices, ascending. `fractions`: of the vertices' lobes of high orders, or empty.
    PixelShading(const PixelInput& input, std::span<const PixelSurface> surfaces,
                 std::span<const glm::vec2> fractions);

    /// For first <= pixel < last writes to out[c][pixel] the mean of channel c's Stokes vectors over the
    /// samples, those without a surface showing the background. Samples of triangles that share a corner are
    /// of one smooth surface, which is shaded once, at their mean.
    PixelCounts run(std::size_t first, std::size_t last, std::span<const std::span<glm::vec4>> out) const;

private:
    // A pixel, or the part of it that shows one surface.
    struct Pixel {
        std::uint32_t surface;
        std::uint32_t occluded;  // 1 where a corner is, which sorts them apart
        std::uint32_t triangle;
        std::uint32_t index;
        float weight;  // the fraction of the pixel's samples
        glm::vec2 at;  // their mean from the pixel's centre, in pixels
        [[nodiscard]] std::uint64_t group() const { return std::uint64_t{2} * surface + occluded; }
    };
    struct Batch;
    struct Patch;

    void collect(std::size_t first, std::size_t last, std::vector<Pixel>& out,
                 std::span<float> coverage) const;
    void add(const Patch& patch, std::size_t index, std::size_t& surface, std::vector<Pixel>& out) const;
    // Pixels of one group, at most as many as a batch has room for.
    void shade(std::span<const Pixel> pixels, Batch& batch, std::span<const std::span<glm::vec4>> out,
               PixelCounts& counts) const;
    void add_small_lights(std::span<const Pixel> pixels, Batch& batch,
                          std::span<const std::span<glm::vec4>> stokes, PixelCounts& counts) const;
    void find_points(std::span<const Pixel> pixels, Batch& batch) const;
    void find_light(const PixelSurface& surface, std::span<const Pixel> pixels, Batch& batch) const;
    // Sorts the batch by the layers that pixels use, and turns its normals. Returns the pixels in that order.
    [[nodiscard]] std::span<const Pixel> find_textures(const TexturedSurface& surface,
                                                       std::span<const Pixel> pixels, Batch& batch) const;
    void find_fractions(std::span<const Pixel> pixels, Batch& batch) const;
    [[nodiscard]] PixelRays rays() const;

    const PixelInput& input_;
    std::span<const PixelSurface> surfaces_;
    std::span<const glm::vec2> fractions_;
    std::optional<PixelLights> small_lights_;
};

}  // namespace nicol
