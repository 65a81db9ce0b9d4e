// SPDX-License-Identifier: MIT
// Points of surfaces that pixels show or that rays meet, and batches of points that are shaded together, on
// threads.
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
#include "polarization/views.hpp"
#include "scene/projection.hpp"
#include "shading/lane_surface.hpp"
#include "surfaces/geometry.hpp"

namespace nicol {

/// Point of a surface whose light is wanted.
struct SurfacePoint {
    std::uint32_t range;     ///< index of the geometry's range
    std::uint32_t occluded;  ///< 1: a corner of the triangle is occluded; else 0
    std::uint32_t triangle;
    /// Index, row by row, of the pixel that gets the light; of a point that a ray meets, a number of the
    /// sample. Seeds light samples.
    std::uint32_t pixel;

    /// Returns the group. Points of one group are shaded by the same data.
    [[nodiscard]] std::uint64_t group() const { return std::uint64_t{2} * range + occluded; }
};

/// Returns the point of a triangle. range: an index of a range, which is tried first because consecutive
/// points often have the same range; becomes the point's range.
[[nodiscard]] SurfacePoint surface_point(const TransferInput& input, std::uint32_t triangle,
                                         std::size_t pixel, std::size_t& range);

/// Pixel, or the part of a pixel that shows one surface.
struct PixelPoint : SurfacePoint {
    float weight;    ///< fraction of the pixel's samples
    glm::vec2 at;    ///< mean position of the point's samples, relative to the pixel's centre, in pixels
    glm::vec2 size;  ///< sides of the rectangle around `at` that the point stands for, in pixels
    bool bent;       ///< whether PixelPoints::parts reflect local lights in place of the point

    [[nodiscard]] std::uint64_t group() const { return 2 * SurfacePoint::group() + (bent ? 1 : 0); }
    /// Returns the mean position of the point's samples, see nicol::on_image_plane().
    [[nodiscard]] glm::dvec2 on_image_plane(const Projection& projection, int width, int height) const;
};

/// Point that a ray meets. The light that leaves the point against the ray is wanted.
struct RayPoint : SurfacePoint {
    float b1, b2;  ///< barycentric weights of the triangle's corners 1 and 2
    /// Viewpoint whose frame() receives the light, in the geometry's axes. For a ray in any direction: an
    /// orthographic one that looks along the ray.
    Viewpoint view;
    bool emits;  ///< whether the surface's own emission is wanted as well
    /// Whether its reflection of bounced light is wanted as well, if that stays apart.
    bool bounces;
    float noise_factor;  ///< from the squared noise of the light to that of the image

    [[nodiscard]] std::uint64_t group() const {
        return 4 * SurfacePoint::group() + (bounces ? 2 : 0) + (emits ? 1 : 0);
    }
};

/// Points of pixels; the points of a group are consecutive.
struct PixelPoints {
    /// Surfaces in the pixels. Samples of triangles that share a corner belong to one surface, which has one
    /// point at their mean.
    std::vector<PixelPoint> whole;
    /// Parts of bent surfaces: samples whose triangles have almost the same geometric normal, or single
    /// samples where a texture perturbs the normals of narrow lobes that reflect much.
    std::vector<PixelPoint> parts;
    /// Whether rays may begin at a sample, see SmoothSurfaces::followed().
    bool followed = false;

    /// Lists the points of pixels first <= i < last. Also writes the fraction of the samples that show a
    /// surface, its back included, to coverage[i - first]. Points of smooth boundaries (input.smooth) are
    /// left out. No surface is bent without local lights. The input's hits must be on the host.
    void list(const PixelInput& input, std::size_t first, std::size_t last, std::span<float> coverage);

private:
    /// Lists the points of an image of one sample a pixel.
    void list_single(const PixelInput& input, std::size_t first, std::size_t last, std::span<float> coverage);
    /// Lists the patches of samples, and their parts.
    void list_patches(const PixelInput& input, std::size_t first, std::size_t last,
                      std::span<float> coverage);
};

/// Image of the points.
struct PointImage {
    const Projection& projection;  ///< projection of the geometry's axes
    int width, height;             ///< size of the image, in pixels
};

/// View of the points.
struct TextureView {
    const WorldGeometry& geometry;
    Views views;  ///< in the geometry's axes
    /// Image whose pixels the points cover. Null: textures are looked up at the points themselves.
    const PointImage* image;
};

/// Textures at a batch of pixels of one surface. Holds results, so each thread needs its own object.
class TexturedPixels {
public:
    /// Finds the textures at points of triangles, and perturbs the normals of surfaces[block of sixteen] and
    /// rotates their tangents.
    /// back: whether the surface is the second side of a two-sided instance, the mirror image of the front.
    /// mirrors: the points in their pixels if LaneSurface::parts are wanted, where textures perturb normals;
    /// needs view.image. Empty: they are not wanted.
    void find(const SpatialVariation& variation, bool back, std::span<const PixelPoint> mirrors,
              const TextureView& view, std::span<const std::uint32_t> triangles,
              std::span<LaneSurface> surfaces);

    /// Returns the weights: [block of sixteen][layer].
    [[nodiscard]] std::span<const LayerWeights> weights() const { return weights_; }
    /// Returns the points of the textures: [block of sixteen].
    [[nodiscard]] std::span<const TexturePoints> points() const { return points_; }

private:
    std::vector<LayerWeights> weights_;
    std::vector<TexturePoints> points_;
};

/// Points of one group, with their positions and textures. Holds results, so each thread needs its own
/// object.
class PixelBatch {
public:
    /// Largest number of points, which spreads the fixed cost of each call over many points.
    static constexpr std::size_t kMost = 16 * kLanes;

    /// Takes the first points: points of one group, at most kMost.
    void take(const PixelInput& input, std::span<const PixelPoint> points);
    void take(const PixelInput& input, std::span<const RayPoint> points);

    [[nodiscard]] std::span<const SurfacePoint> points() const { return points_; }
    /// Returns the points as parts of pixels. Empty: the points are those of rays and cover nothing.
    [[nodiscard]] std::span<const PixelPoint> in_pixels() const { return in_pixels_; }
    [[nodiscard]] const Views& views() const { return views_; }
    /// Returns whether the points reflect local lights; otherwise their parts do.
    [[nodiscard]] bool reflects_lights() const { return in_pixels_.empty() || !in_pixels_.front().bent; }
    /// Returns whether the surface's own emission is wanted.
    [[nodiscard]] bool emits() const { return emits_; }
    /// Returns whether the reflection of bounced light that stays apart is wanted as well.
    [[nodiscard]] bool bounces() const { return bounces_; }
    /// Returns LitPoints::noise_factors. The points of a pixel share their samples of light, so that their
    /// noise adds as they do.
    [[nodiscard]] std::span<const float> noise_factors() const { return noise_factors_; }
    /// Returns surfaces of sixteen points each, with normals perturbed by textures.
    [[nodiscard]] std::span<const LaneSurface> surfaces() const {
        return std::span(surfaces_).first((points_.size() + kLanes - 1) / kLanes);
    }
    /// Returns the weights of a textured material's layers, [sixteen points][layer]; empty: no textures.
    [[nodiscard]] std::span<const LayerWeights> weights() const { return weights_; }
    /// Sets other weights of a textured material's layers, which must last until the next take().
    void weigh(std::span<const LayerWeights> weights) { weights_ = weights; }
    /// Returns the points of a textured material's textures, [sixteen points].
    [[nodiscard]] std::span<const TexturePoints> texture_points() const { return textures_.points(); }

    /// Adds to out[c][pixel - first] the stokes[c][point] of in_pixels() times their weights, for the first
    /// `components` Stokes components.
    void gather(std::span<const std::span<glm::vec4>> stokes, std::size_t components, std::size_t first,
                std::span<const std::span<glm::vec4>> out) const;

private:
    template <class Point>
    std::span<const Point> take_group(std::span<const Point> points);
    void find_surfaces(const PixelInput& input);
    void find_surfaces(const PixelInput& input, std::span<const RayPoint> points);
    void find_textures(const PixelInput& input);

    std::vector<SurfacePoint> points_;
    std::span<const PixelPoint> in_pixels_;
    std::vector<Viewpoint> ray_views_;
    std::vector<float> noise_factors_;
    bool emits_ = true, bounces_ = true;
    Views views_{std::span<const Viewpoint>()};
    std::array<LaneSurface, kMost / kLanes> surfaces_;
    std::span<const LayerWeights> weights_;
    // Textures of a textured material.
    TexturedPixels textures_;
    std::vector<std::uint32_t> triangles_;
};

}  // namespace nicol
