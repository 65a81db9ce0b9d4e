// SPDX-License-Identifier: MIT
#include "devices/pixel_batch.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "draw/visibility_buffer.hpp"
#include "shading/lane_footprint.hpp"
#include "shading/normal_variation.hpp"
#include "shading/pixel_places.hpp"
#include "shading/tangent_rotation.hpp"
#include "surfaces/local_lights.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {
namespace {

PixelSteps steps_of(const PointImage& image) {
    const Projection& p = image.projection;
    return {.forward = p.view.forward,
            .right = p.view.right * (2 * p.texture_size * p.half_width / image.width),
            .down = p.view.up * (-2 * p.texture_size * p.half_height / image.height),
            .orthographic = p.view.orthographic};
}

// Input of textures and normals at sixteen points.
class Block {
public:
    // back: whether the surface is the second side of a two-sided instance.
    Block(const SpatialVariation& variation, bool back, const TextureView& view)
        : view_(view),
          normal_(variation.normal),
          front_(back ? -1.0F : 1.0F),
          footprint_(view.image != nullptr && variation.needs_footprint()),
          follows_(variation.normal.kind == NormalVariation::Kind::map || variation.rotation.any()),
          axes_(footprint_ || follows_ || variation.normal.kind != NormalVariation::Kind::none) {
        if (view.image != nullptr) steps_ = steps_of(*view.image);
    }

    // Sets the input at points of up to sixteen triangles; the other lanes repeat the first.
    void set(std::span<const std::uint32_t> triangles, const Views& views, const LaneSurface& surface) {
        const WorldGeometry& geometry = view_.geometry;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t own = i < triangles.size() ? i : 0;
            const std::uint32_t triangle = triangles[own];
            const Viewpoint& viewer = views.at(own);
            const glm::vec3 weights(surface.weights[0][i], surface.weights[1][i], surface.weights[2][i]);
            const glm::vec3 ray = viewer.orthographic ? glm::vec3(viewer.forward)
                                                      : surface.positions[i] - glm::vec3(viewer.eye);
            put(towards_viewer, i, -ray);
            put(normals, i, surface.normals[i]);
            if (!geometry.texcoords.empty()) {
                const std::array<glm::vec2, 3>& texcoords = geometry.texcoords[triangle];
                if (axes_ && triangle != known_) {
                    known_ = triangle;
                    triangle_axes_ = texture_axes(geometry, triangle);
                }
                for (glm::length_t k = 0; k < 2; ++k)
                    points.uv[static_cast<std::size_t>(k)][i] = weights.x * texcoords[0][k] +
                                                                weights.y * texcoords[1][k] +
                                                                weights.z * texcoords[2][k];
                put(axes.by_u, i, triangle_axes_.by_u);
                put(axes.by_v, i, triangle_axes_.by_v);
            }
            if (!geometry.colors.empty()) {
                const std::array<glm::vec3, 3>& colors = geometry.colors[triangle];
                for (glm::length_t k = 0; k < 3; ++k)
                    points.color[static_cast<std::size_t>(k)][i] =
                        weights.x * colors[0][k] + weights.y * colors[1][k] + weights.z * colors[2][k];
            }
        }
        if (footprint_) find_footprints(steps_, axes, towards_viewer, points);
        if (follows_) find_followed_axes(triangles, surface);
    }

    // Returns the rotated x axis at a point.
    [[nodiscard]] glm::vec3 tangent(const TangentRotation& rotation, std::size_t i) const {
        return rotated_tangent(rotation, points.at(i),
                               {.by_u = vector_at(followed.by_u, i), .by_v = vector_at(followed.by_v, i)},
                               front_ * vector_at(normals, i));
    }

    TexturePoints points{};
    LaneTextureAxes axes{};
    LaneTextureAxes followed{};  // axes that normal maps and anisotropic materials follow
    LaneVectors towards_viewer, normals;

    // Perturbs the normals.
    void turn(LaneVectors& turned) const { turn_at(points, turned); }

    // Finds the perturbed normals of the parts of up to sixteen points.
    void find_parts(std::span<const PixelPoint> in_pixels, LaneSurface& surface) const {
        constexpr std::size_t across = LaneSurface::kPartsAcross;
        TexturePoints here = points;
        find_footprints(steps_, axes, towards_viewer, here);
        const Projection& projection = view_.image->projection;
        const auto sample = static_cast<float>(projection.sample_size / projection.texture_size);
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::vec2 part = sample / across * in_pixels[i < in_pixels.size() ? i : 0].size;
            for (std::size_t k = 0; k < 2; ++k) {
                here.du[k][i] *= part.x;
                here.dv[k][i] *= part.y;
            }
        }
        for (std::size_t part = 0; part < surface.parts.size(); ++part) {
            const glm::vec2 place = static_cast<float>(across) * MirroredParts::middle(part);
            TexturePoints there = here;
            for (std::size_t k = 0; k < 2; ++k)
                for (std::size_t i = 0; i < kLanes; ++i)
                    there.uv[k][i] += place.x * here.du[k][i] + place.y * here.dv[k][i];
            surface.parts[part] = normals;
            turn_at(there, surface.parts[part]);
        }
    }

private:
    void turn_at(const TexturePoints& at, LaneVectors& turned) const {
        const bool map = normal_.kind == NormalVariation::Kind::map;
        turn_normals(normal_, at, map ? followed : axes, front_ < 0, towards_viewer, turned);
    }

    void find_followed_axes(std::span<const std::uint32_t> triangles, const LaneSurface& surface) {
        followed = axes;
        if (view_.geometry.tangents.empty()) return;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const glm::vec3 weights(surface.weights[0][i], surface.weights[1][i], surface.weights[2][i]);
            const TextureAxes of_point = material_axes(
                view_.geometry, triangles[i < triangles.size() ? i : 0], weights, front_ * surface.normals[i],
                {.by_u = vector_at(axes.by_u, i), .by_v = vector_at(axes.by_v, i)});
            put(followed.by_u, i, of_point.by_u);
            put(followed.by_v, i, of_point.by_v);
        }
    }

    const TextureView& view_;
    const NormalVariation& normal_;
    PixelSteps steps_{};  // set if there is an image
    float front_;         // factor of normals that makes them those of the front
    bool footprint_, follows_, axes_;
    std::uint32_t known_ = ~std::uint32_t{0};  // previous triangle, which is often the same
    TextureAxes triangle_axes_;
};

}  // namespace

void TexturedPixels::find(const SpatialVariation& variation, bool back, std::span<const PixelPoint> mirrors,
                          const TextureView& view, std::span<const std::uint32_t> triangles,
                          std::span<LaneSurface> surfaces) {
    const std::size_t layers = variation.layers.size();
    weights_.resize(surfaces.size() * layers);
    points_.resize(surfaces.size());
    Block block(variation, back, view);
    for (std::size_t b = 0; b < surfaces.size(); ++b) {
        const std::span own = triangles.subspan(b * kLanes, std::min(kLanes, triangles.size() - b * kLanes));
        block.set(own, view.views.subspan(b * kLanes, own.size()), surfaces[b]);
        const std::span weights = std::span(weights_).subspan(b * layers, layers);
        variation.weights(block.points, weights);
        points_[b] = block.points;
        for (std::size_t i = 0; i < kLanes && variation.rotation.any(); ++i)
            surfaces[b].tangents[i] = block.tangent(variation.rotation, i);
        if (variation.normal.kind == NormalVariation::Kind::none) continue;
        surfaces[b].unperturbed = surfaces[b].normals;
        if (!mirrors.empty()) block.find_parts(mirrors.subspan(b * kLanes, own.size()), surfaces[b]);
        LaneVectors turned = block.normals;
        block.turn(turned);
        for (std::size_t i = 0; i < kLanes; ++i) surfaces[b].normals[i] = vector_at(turned, i);
    }
}

// Takes the first points of one group, and returns them.
template <class Point>
std::span<const Point> PixelBatch::take_group(std::span<const Point> points) {
    const std::uint64_t group = points.front().group();
    std::size_t count = 0;
    while (count < points.size() && count < kMost && points[count].group() == group) ++count;
    points_.assign(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(count));
    weights_ = {};
    return points.first(count);
}

void PixelBatch::take(const PixelInput& input, std::span<const PixelPoint> points) {
    in_pixels_ = take_group(points);
    emits_ = bounces_ = true;
    noise_factors_.clear();
    for (const PixelPoint& point : in_pixels_) noise_factors_.push_back(point.weight);
    views_ = input.view;
    find_surfaces(input);
    find_textures(input);
}

void PixelBatch::take(const PixelInput& input, std::span<const RayPoint> points) {
    const std::span of_group = take_group(points);
    in_pixels_ = {};
    emits_ = points.front().emits;
    bounces_ = points.front().bounces;
    ray_views_.clear();
    noise_factors_.clear();
    for (const RayPoint& point : of_group) {
        ray_views_.push_back(point.view);
        noise_factors_.push_back(point.noise_factor);
    }
    views_ = Views(ray_views_);
    find_surfaces(input, of_group);
    find_textures(input);
}

void PixelBatch::find_surfaces(const PixelInput& input) {
    const WorldGeometry& geometry = input.geometry;
    for (std::size_t begin = 0; begin < in_pixels_.size(); begin += kLanes) {
        const std::size_t count = std::min(kLanes, in_pixels_.size() - begin);
        std::array<Corners, kLanes> triangles;
        std::array<glm::vec2, kLanes> at;
        for (std::size_t i = 0; i < count; ++i) {
            const PixelPoint& point = in_pixels_[begin + i];
            triangles[i] = geometry.triangles[point.triangle];
            at[i] =
                glm::vec2(point.on_image_plane(input.projection, input.hits.width(), input.hits.height()));
        }
        find_surface(input.view, geometry.positions, geometry.normals, std::span(triangles).first(count),
                     std::span(at).first(count), surfaces_[begin / kLanes]);
    }
}

void PixelBatch::find_surfaces(const PixelInput& input, std::span<const RayPoint> points) {
    const WorldGeometry& geometry = input.geometry;
    for (std::size_t i = 0; i < surfaces().size() * kLanes; ++i) {
        const RayPoint& point = points[i < points.size() ? i : i / kLanes * kLanes];
        const Corners& corners = geometry.triangles[point.triangle];
        const glm::vec3 weights(1 - point.b1 - point.b2, point.b1, point.b2);
        LaneSurface& surface = surfaces_[i / kLanes];
        const std::size_t lane = i % kLanes;
        glm::vec3 position(0), normal(0);
        for (glm::length_t k = 0; k < 3; ++k) {
            surface.weights[static_cast<std::size_t>(k)][lane] = weights[k];
            position += weights[k] * geometry.positions[corners[k]];
            normal += weights[k] * geometry.normals[corners[k]];
        }
        const float length = glm::length(normal);
        surface.positions[lane] = position;
        surface.normals[lane] =
            length > 1e-6F ? normal / length : glm::vec3(point.view.towards(glm::dvec3(position)));
    }
}

void PixelBatch::find_textures(const PixelInput& input) {
    const VertexRange& range = input.geometry.ranges[points_.front().range];
    if (range.material->variation() == nullptr) return;
    triangles_.clear();
    for (const SurfacePoint& point : points_) triangles_.push_back(point.triangle);
    const PointImage image{
        .projection = input.projection, .width = input.hits.width(), .height = input.hits.height()};
    const bool covering = !in_pixels_.empty();
    const bool mirrors = covering && input.local_lights != nullptr &&
                         input.local_lights->lighting().needs_pixels(*range.material);
    textures_.find(*range.material->variation(), is_back(input.geometry, range),
                   mirrors ? in_pixels_ : std::span<const PixelPoint>(),
                   {.geometry = input.geometry, .views = views_, .image = covering ? &image : nullptr},
                   triangles_, std::span(surfaces_).first(surfaces().size()));
    weights_ = textures_.weights();
}

void PixelBatch::gather(std::span<const std::span<glm::vec4>> stokes, std::size_t components,
                        std::size_t first, std::span<const std::span<glm::vec4>> out) const {
    glm::vec4 wanted(0);
    for (std::size_t p = 0; p < components; ++p) wanted[static_cast<glm::length_t>(p)] = 1;
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < in_pixels_.size(); ++i)
            out[c][in_pixels_[i].pixel - first] += in_pixels_[i].weight * wanted * stokes[c][i];
}

}  // namespace nicol
