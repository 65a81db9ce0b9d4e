// SPDX-License-Identifier: MIT
// Points that the pixels of an image show, and batches of them that are shaded together, on threads.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "material/spatial_variation.hpp"
#include "methods/executor.hpp"
#include "scene/projection.hpp"
#include "shading/lane_surface.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// A pixel, or the part of it that shows one surface.
struct PixelPoint {
    std::uint32_t range;     ///< number of one of the geometry's
    std::uint32_t occluded;  ///< 1 where a corner of the triangle is
    std::uint32_t triangle;
    std::uint32_t pixel;  ///< row by row
    float weight;         ///< the fraction of the pixel's samples
    glm::vec2 at;         ///< their mean from the pixel's centre, in pixels

    /// Points of one group are shaded alike.
    [[nodiscard]] std::uint64_t group() const { return std::uint64_t{2} * range + occluded; }
};

/// The points of pixels first <= i < last, those of a group side by side; and into coverage[i - first] the
/// fraction of the samples that show a surface, from its back as well. Samples of triangles that share a
/// corner are of one smooth surface, which has one point, at their mean. The input's hits are on the host.
void list_points(const PixelInput& input, std::size_t first, std::size_t last, std::vector<PixelPoint>& out,
                 std::span<float> coverage);

/// The view in which points are seen.
struct TextureView {
    const WorldGeometry& geometry;
    const Projection& projection;  ///< of the geometry's axes
    int width, height;             ///< of the image, in pixels
};

/// Textures at a batch of pixels of one surface. Holds results; one object a thread.
class TexturedPixels {
public:
    /// Finds the textures at points of triangles and turns their normals: surfaces[block of sixteen]. back:
    /// the surface is the second side of a two-sided instance; it is its front's mirror image.
    void find(const SpatialVariation& variation, bool back, const TextureView& view,
              std::span<const std::uint32_t> triangles, std::span<LaneSurface> surfaces);

    /// [block of sixteen][layer].
    [[nodiscard]] std::span<const LayerWeights> weights() const { return weights_; }

private:
    std::vector<LayerWeights> weights_;
};

/// Points of one group: where they lie, and what textures are there. Holds results; one object a thread.
class PixelBatch {
public:
    /// Points, so that what every call costs counts for many.
    static constexpr std::size_t kMost = 16 * kLanes;

    /// Takes the first of the points: those of one group, as many as there is room for.
    void take(const PixelInput& input, std::span<const PixelPoint> points);

    [[nodiscard]] std::span<const PixelPoint> points() const { return points_; }
    /// Surfaces of sixteen points each; their normals are those of textures.
    [[nodiscard]] std::span<const LaneSurface> surfaces() const {
        return std::span(surfaces_).first((points_.size() + kLanes - 1) / kLanes);
    }
    /// [sixteen points][layer] of a material that varies; empty: it does not.
    [[nodiscard]] std::span<const LayerWeights> weights() const { return weights_; }

    /// Adds to out[c][pixel - first] the points' stokes[c][point], times their weights: the first so many
    /// components.
    void gather(std::span<const std::span<glm::vec4>> stokes, std::size_t components, std::size_t first,
                std::span<const std::span<glm::vec4>> out) const;

private:
    void find_surfaces(const PixelInput& input);
    void find_textures(const PixelInput& input, const VertexRange& range);

    std::span<const PixelPoint> points_;
    std::array<LaneSurface, kMost / kLanes> surfaces_;
    std::span<const LayerWeights> weights_;
    // Textures, if the material varies.
    TexturedPixels textures_;
    std::vector<std::uint32_t> triangles_;
};

}  // namespace nicol
