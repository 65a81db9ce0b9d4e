// SPDX-License-Identifier: MIT
// Gradients of the light of points in pixels, on threads.
#pragma once

#include <cstddef>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "devices/adjoint/texture_gradient.hpp"
#include "devices/adjoint/vertex_gradient.hpp"
#include "devices/pixel_batch.hpp"
#include "image/stokes_image.hpp"
#include "material/response_table.hpp"
#include "shading/local_lighting.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"

namespace nicol {

/// Sums of gradients over points, in double precision.
struct GradientSums {
    std::vector<double> distant;  ///< [range][channel][number of the layout], in the geometry's axes
    std::vector<double> lights;   ///< [range][light][component][channel]

    GradientSums& operator+=(const GradientSums& other);
};

/// Transpose of PixelShading and SurfaceShading: from a gradient of pixels to gradients of the light of the
/// vertices, of unoccluded light and of local lights.
class PointGradient {
public:
    /// Keeps references. responses: [range][layer]. lights: one lighting for each local light, by its
    /// unit_sources(). texture: null, or a texture of which the gradient is wanted as well.
    PointGradient(const PixelInput& input, const StokesImage& picture,
                  std::span<const std::vector<const ResponseTable*>> responses,
                  std::span<const LocalLighting> lights, VertexGradient& vertices, TextureGradient* texture);

    /// Adds the gradients of the pixels first <= pixel < last. Calls for different pixels may run side by
    /// side, with sums of their own.
    void add(std::size_t first, std::size_t last, GradientSums& sums) const;

private:
    struct Work;

    void take_gradient(Work& work) const;
    void add_distant(Work& work, GradientSums& sums) const;
    void add_lights(Work& work, GradientSums& sums) const;
    void add_texture(Work& work, const TextureGradient::Reflected& reflected) const;

    const PixelInput& input_;
    const StokesImage& picture_;
    std::span<const std::vector<const ResponseTable*>> responses_;
    std::span<const LocalLighting> lights_;
    VertexGradient& vertices_;
    TextureGradient* texture_;
    FrameRotation rotation_;
};

/// Adds a block of light to the sums of a range: those of its first `count` lanes.
void add_lanes(const VertexLight& light, std::size_t block, std::size_t first, std::size_t count,
               std::span<double> sums);

}  // namespace nicol
