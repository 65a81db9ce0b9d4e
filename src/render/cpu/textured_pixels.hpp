// SPDX-License-Identifier: MIT
// What textures are at pixels.
#pragma once

#include <cstddef>
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

    /// Points that the same layers have a weight at follow one another: the i-th is order()[i]. Empty: they
    /// do as they were given.
    [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
    /// Of the points in that order: [block of sixteen][layer].
    [[nodiscard]] std::span<const LayerWeights> weights() const { return order_.empty() ? given_ : ordered_; }

private:
    // Sorts by used_.
    void find_order();
    void order_weights(std::size_t layers);

    // Points with the same layers.
    struct Kind {
        std::uint64_t used;
        std::uint32_t points;
    };

    // The layers that have a weight at a point as given: bit l % 64.
    std::vector<std::uint64_t> used_;
    std::vector<Kind> kinds_;
    std::vector<std::uint32_t> order_;
    std::vector<LayerWeights> given_, ordered_;  // [block][layer]
};

}  // namespace nicol
