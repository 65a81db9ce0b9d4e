// SPDX-License-Identifier: MIT
// Gradients by a texture that is a factor of what materials reflect.
#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "devices/pixel_batch.hpp"
#include "devices/pixel_lights.hpp"
#include "material/response_table.hpp"
#include "methods/executor.hpp"
#include "texture/texel_gradient.hpp"
#include "transfer/frame_rotation.hpp"
#include "transfer/vertex_light.hpp"
#include "transfer/visibility_product.hpp"

namespace nicol {

/// Gradient by the texels of one texture. Calls for different batches may run side by side.
class TextureGradient {
public:
    /// Keeps references. responses: [range][layer]. shadows: of the vertices; null: nothing casts any.
    TextureGradient(const PixelInput& input, std::span<const std::vector<const ResponseTable*>> responses,
                    const VisibilityProduct* shadows, TexturePtr texture, RenderRun& run);

    /// Returns whether the texture is a factor of what a range's material reflects.
    [[nodiscard]] bool varies(std::size_t range) const { return of_ranges_[range].has_value(); }

    /// Light that a batch of points reflects.
    struct Reflected {
        /// Positions and normals of the points, which reflect distant light; empty: they reflect none.
        std::span<const glm::vec3> positions, normals;
        bool local;  ///< whether local lights are reflected
    };
    /// Adds the gradient of a batch of points whose range varies(). stokes: the gradient of what the points
    /// reflect, [channel][point]. Changes the batch's weights.
    void add(PixelBatch& batch, std::span<const std::span<glm::vec4>> stokes, const Reflected& reflected);

    /// Returns the gradient by the texture's texels, [row][column][channel], once.
    [[nodiscard]] std::vector<double> take_texels() { return texels_.take(); }

private:
    struct Work;

    void relight(const VisibilityProduct* shadows, RenderRun& run);
    /// Adds to work.by_weight what the points reflect of distant light by one layer.
    void add_distant(const PixelBatch& batch, const Reflected& reflected, std::size_t layer,
                     std::span<const std::span<glm::vec4>> stokes, Work& work) const;
    /// Sets work.own to a row of the light at a point, in the geometry's axes.
    void find_own(const PixelBatch& batch, std::size_t point, Work& work) const;
    /// Does the same for local lights.
    void add_local(PixelBatch& batch, std::size_t layer, std::span<const std::span<glm::vec4>> stokes,
                   Work& work) const;
    /// Adds gradients by the texture's values to work.by_value from those by one layer's weights.
    void add_values(const PixelBatch& batch, std::size_t layer, Work& work) const;

    const PixelInput& input_;
    std::span<const std::vector<const ResponseTable*>> responses_;
    TexturePtr texture_;
    FrameRotation rotation_;
    std::vector<std::optional<std::size_t>> of_ranges_;  // index of the texture in the material's
    VertexLight light_;                                  // of the vertices, rows in the geometry's axes
    VertexLight unoccluded_;                             // the same of points without shadows
    TexelGradient texels_;
};

}  // namespace nicol
