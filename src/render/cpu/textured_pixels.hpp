// SPDX-License-Identifier: MIT
// What textures are at pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "material/spatial_variation.hpp"
#include "render/geometry.hpp"
#include "scene/projection.hpp"
#include "specular/layered_rows.hpp"

namespace nicol {

/// A point of a surface that a pixel shows.
struct SurfacePoint {
    std::uint32_t triangle;
    std::uint32_t pixel;  ///< of a batch
    glm::vec3 weights;    ///< barycentric
    glm::vec3 position;
    glm::vec3 normal;  ///< unit
};

/// Where points are seen from.
struct TextureView {
    const WorldGeometry& geometry;
    const Projection& projection;  ///< of the geometry's axes
    int width, height;             ///< of the image, in pixels
};

/// Of a batch of pixels of one surface. Holds results; one object a thread.
class TexturedPixels {
public:
    /// Sorts the points so that those which the same layers have a weight at follow one another, and turns
    /// their normals. back: of the second side of a two-sided instance; it is its front's mirror image.
    void find(const SpatialVariation& variation, bool back, const TextureView& view,
              std::span<SurfacePoint> points);

    /// Of the points in their new order: [layer][block of sixteen].
    [[nodiscard]] std::span<const std::span<const LayerWeights>> weights() const { return by_layer_; }

private:
    // The layers with a weight: bit l % 64.
    struct Used {
        std::uint64_t layers;
        std::uint32_t point;
    };
    void store_weights(std::size_t layers);

    std::vector<glm::vec3> weights_;  // [point as given][layer]
    std::vector<Used> used_;          // in the points' new order
    std::vector<SurfacePoint> given_;
    std::vector<LayerWeights> lanes_;  // [layer][block]
    std::vector<std::span<const LayerWeights>> by_layer_;
};

}  // namespace nicol
