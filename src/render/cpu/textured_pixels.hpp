// SPDX-License-Identifier: MIT
// What textures are at pixels.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "material/spatial_variation.hpp"
#include "render/geometry.hpp"
#include "scene/projection.hpp"
#include "shading/lane_surface.hpp"

namespace nicol {

/// Where points are seen from.
struct TextureView {
    const WorldGeometry& geometry;
    const Projection& projection;  ///< of the geometry's axes
    int width, height;             ///< of the image, in pixels
};

/// Of a batch of pixels of one surface. Holds results; one object a thread.
class TexturedPixels {
public:
    /// Of the points of triangles, whose normals it turns: surfaces[block of sixteen]. back: of the second
    /// side of a two-sided instance; it is its front's mirror image.
    void find(const SpatialVariation& variation, bool back, const TextureView& view,
              std::span<const std::uint32_t> triangles, std::span<LaneSurface> surfaces);

    /// [block of sixteen][layer].
    [[nodiscard]] std::span<const LayerWeights> weights() const { return weights_; }

private:
    std::vector<LayerWeights> weights_;
};

}  // namespace nicol
