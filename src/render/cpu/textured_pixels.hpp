// SPDX-License-Identifier: MIT
// What textures are at pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "material/spatial_variation.hpp"
#include "render/geometry.hpp"
#include "scene/projection.hpp"

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

    /// Sets shown[i] to 1 where the layer has a weight at point i, to 0 elsewhere. Returns whether any is 1.
    bool shown(std::size_t layer, std::span<std::uint8_t> shown) const;
    /// sum[c][i] += the layer's weight at point i, channel c, times part[c][i], where shown() has 1.
    void add(std::size_t layer, std::span<const std::span<glm::vec4>> part,
             std::span<const std::span<glm::vec4>> sum) const;

private:
    // The layers with a weight: bit l % 64.
    struct Used {
        std::uint64_t layers;
        std::uint32_t point;
    };

    [[nodiscard]] const glm::vec3& weight(std::size_t point, std::size_t layer) const {
        return weights_[used_[point].point * layers_ + layer];
    }

    std::size_t layers_ = 0;
    std::vector<TexturePoint> textures_;
    std::vector<glm::vec3> weights_;  // [point as given][layer]
    std::vector<Used> used_;          // in the points' new order
    std::vector<SurfacePoint> given_;
};

}  // namespace nicol
