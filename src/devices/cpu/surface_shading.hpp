// SPDX-License-Identifier: MIT
// Light that leaves points of surfaces towards viewers, on threads.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "devices/pixel_batch.hpp"
#include "devices/pixel_lights.hpp"
#include "material/response_table.hpp"
#include "methods/executor.hpp"
#include "shading/shade.hpp"
#include "specular/high_order.hpp"
#include "specular/high_order_layers.hpp"
#include "stage/workers.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Data for shading a textured material.
struct TexturedSurface {
    std::vector<const ResponseTable*> responses;  ///< response tables of the layers
    std::optional<HighOrderLayers> high_orders;
};

/// Terms of a surface that reflect the bounced light at vertices which stays apart.
struct BouncedSurface {
    const Shade* shade;
    const VertexLight* light;  ///< bounced light as rows
    const FrameRotation* rotation;
    std::vector<const ResponseTable*> responses;  ///< response tables of the material's layers
};

/// Data for shading the points of one range.
struct PointSurface {
    const Shade* shade;
    const TexturedSurface* textures;  ///< textured material, in place of response and high_orders; or null
    /// Response of a material without textures; null as well: no term of the material reflects harmonics.
    const ResponseTable* response;
    const HighOrder* high_orders;   ///< high orders of the material, or null
    const VertexLight* light;       ///< light as rows
    std::size_t first_row;          ///< index of the vertex of the light's first row
    const FrameRotation* rotation;  ///< rotation of the light
    const Relight* unoccluded;      ///< relight for points between unoccluded vertices, or null
    const BouncedSurface* bounced;  ///< reflection of bounced light that is not in `light`, or null
};

/// Counts and times of shading points.
struct PointCounts {
    std::size_t shaded = 0;  ///< number of shaded points
    LightingTally lighting{};
    LightingTally followed{};     ///< of the light that rays find for lobes
    SurfaceTally surfaces{};      ///< of the image
    double light_seconds = 0;     ///< time of one thread for local lights, in seconds
    std::uint64_t ray_count = 0;  ///< number of rays from smooth surfaces
};

/// Computes what leaves points of surfaces: the incident field kept at vertices, interpolated, times the
/// response of the material at the viewer's angle, high orders, the reflection of local lights, and emission.
/// Calls for different points may run in parallel.
class SurfaceShading {
public:
    /// Keeps references. surfaces: one per range of the geometry. fractions: visible fractions of the
    /// vertices' lobes of high orders as the camera sees them, or empty.
    SurfaceShading(const PixelInput& input, std::span<const PointSurface> surfaces,
                   std::span<const glm::vec2> fractions);

    /// Writes to out[c][i] channel c's Stokes vector of the light that leaves point i of the batch for its
    /// viewer, in the frame field of its viewpoint. The viewer must be in front of the point's triangle.
    void run(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out, PointCounts& counts) const;

    /// Adds only the reflection of local lights, which the input must have, and emission.
    void add_lights(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out,
                    PointCounts& counts) const;

    [[nodiscard]] const PixelInput& input() const noexcept { return input_; }

private:
    struct Work;

    /// Writes what the surface reflects of the light kept at vertices, and its high orders, to out.
    void reflect_harmonics(const PointSurface& surface, const PixelBatch& batch, Work& work,
                           std::span<const std::span<glm::vec4>> out) const;
    void find_light(const PointSurface& surface, const PixelBatch& batch, Work& work) const;
    /// Interpolates the light of the vertices, which rows from first_row on have, into work.light.
    void interpolate(const LightLayout& layout, const VertexLight& rows, std::size_t first_row,
                     const FrameRotation& rotation, const PixelBatch& batch, Work& work) const;
    /// Adds what `surface` reflects to out.
    void add_bounced(const BouncedSurface& surface, const PixelBatch& batch, Work& work,
                     std::span<const std::span<glm::vec4>> out) const;
    void find_fractions(const PixelBatch& batch, Work& work) const;
    /// Finds the visible fractions as the viewers of the batch's points see them.
    void find_fractions_of_views(const PixelBatch& batch, Work& work) const;

    const PixelInput& input_;
    std::span<const PointSurface> surfaces_;
    std::span<const glm::vec2> fractions_;
    std::optional<PixelLights> local_lights_;
};

}  // namespace nicol
