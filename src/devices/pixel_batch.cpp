// SPDX-License-Identifier: MIT
#include "devices/pixel_batch.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "draw/visibility_buffer.hpp"
#include "shading/lane_footprint.hpp"
#include "shading/normal_variation.hpp"
#include "shading/pixel_places.hpp"
#include "shading/tangent_rotation.hpp"
#include "surfaces/local_lights.hpp"
#include "surfaces/smooth_surfaces.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {
namespace {

bool share_corner(const glm::uvec3& a, const glm::uvec3& b) {
    const auto in_b = [&b](std::uint32_t v) { return v == b.x || v == b.y || v == b.z; };
    return in_b(a.x) || in_b(a.y) || in_b(a.z);
}

// Samples of one smooth surface in one pixel.
struct Patch {
    std::array<std::uint32_t, kMostPixelSamples> triangles;
    std::array<glm::vec2, kMostPixelSamples> at;  // relative to the pixel's centre
    std::size_t samples = 0;

    void add(std::uint32_t triangle, const glm::vec2& place) {
        triangles[samples] = triangle;
        at[samples++] = place;
    }
};

// Returns the sides of a rectangle with the area of a patch, and stretched as its samples are. mean: of the
// samples' positions. weight: the patch's part of the pixel.
glm::vec2 size_of(const Patch& patch, const glm::vec2& mean, float weight) {
    glm::vec2 squares(1 / 64.0F);  // of the least distance between two samples along an axis
    for (const glm::vec2& at : std::span(patch.at).first(patch.samples))
        squares += 12.0F / static_cast<float>(patch.samples) * (at - mean) * (at - mean);
    const float stretch = std::sqrt(std::sqrt(squares.x / squares.y));
    return std::sqrt(weight) * glm::vec2(stretch, 1 / stretch);
}

// Returns the point of a patch. range: the previous patch's range, which is often the same; becomes this
// patch's range.
PixelPoint point_of(const Patch& patch, const PixelInput& input, std::size_t pixel, std::size_t& range) {
    glm::vec2 mean(0);
    for (const glm::vec2& at : std::span(patch.at).first(patch.samples)) mean += at;
    mean /= static_cast<float>(patch.samples);
    // The mean may lie between triangles, so the triangle of the nearest sample represents the patch.
    std::size_t nearest = 0;
    for (std::size_t s = 1; s < patch.samples; ++s) {
        const glm::vec2 d = patch.at[s] - mean;
        const glm::vec2 least = patch.at[nearest] - mean;
        if (glm::dot(d, d) < glm::dot(least, least)) nearest = s;
    }
    const float weight = static_cast<float>(patch.samples) / static_cast<float>(input.hits.offsets().size());
    return {surface_point(input, patch.triangles[nearest], pixel, range), weight, mean,
            size_of(patch, mean, weight), false};
}

// Returns the unit geometric normal of a triangle, 0 without an area.
glm::vec3 facet_of(const WorldGeometry& geometry, std::uint32_t triangle) {
    const std::vector<glm::vec3>& at = geometry.positions;
    const glm::uvec3& t = geometry.triangles[triangle];
    const glm::vec3 normal = glm::cross(at[t.y] - at[t.x], at[t.z] - at[t.x]);
    const float length = glm::length(normal);
    return length > 0 ? normal / length : glm::vec3(0);
}

// Divides a surface into parts, because the mean position of samples on both sides of an edge says little of
// highlights, and nothing of lights that only one side sees. Returns the number of parts.
std::size_t divide(const Patch& patch, const WorldGeometry& geometry,
                   std::array<Patch, kMostPixelSamples>& parts) {
    constexpr float most_bend = 0.05F;  // radians between the facets of a part and its first one
    const std::span triangles = std::span(patch.triangles).first(patch.samples);
    if (std::ranges::count(triangles, triangles.front()) == std::ssize(triangles)) return 1;
    std::array<glm::vec3, kMostPixelSamples> facets;
    std::size_t count = 0;
    for (std::size_t s = 0; s < patch.samples; ++s) {
        const glm::vec3 facet = facet_of(geometry, patch.triangles[s]);
        std::size_t part = 0;
        while (part < count && glm::distance(facets[part], facet) > most_bend) ++part;
        if (part == count) {
            facets[count] = facet;
            parts[count++].samples = 0;
        }
        parts[part].add(patch.triangles[s], patch.at[s]);
    }
    return count;
}

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

    // Finds the perturbed normals of the samples' parts.
    void find_parts(LaneSurface& surface) const {
        constexpr std::size_t across = LaneSurface::kPartsAcross;
        TexturePoints here = points;
        find_footprints(steps_, axes, towards_viewer, here);
        const Projection& projection = view_.image->projection;
        const auto sample = static_cast<float>(projection.sample_size / projection.texture_size);
        for (std::array<Lanes, 2>* const steps : {&here.du, &here.dv})
            for (Lanes& step : *steps)
                for (float& value : step.value) value *= sample / across;
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

void PixelPoints::list(const PixelInput& input, std::size_t first, std::size_t last,
                       std::span<float> coverage) {
    whole.clear();
    parts.clear();
    const bool lit = input.local_lights != nullptr && input.local_lights->lighting().any_source();
    const std::span offsets = input.hits.offsets();
    const std::span triangles(input.geometry.triangles);
    const float weight = 1.0F / static_cast<float>(offsets.size());
    std::array<Patch, kMostPixelSamples> patches, bent;
    std::size_t range = 0;
    for (std::size_t i = first; i < last; ++i) {
        std::size_t count = 0;
        std::size_t covered = 0;
        for (std::size_t s = 0; s < offsets.size(); ++s) {
            const std::optional<Hit> hit = input.hits.at(s, i);
            if (!hit) continue;
            ++covered;
            if (!hit->front) continue;
            if (input.smooth != nullptr && input.smooth->of(hit->triangle) == Smoothness::boundary) continue;
            const auto same = [&](const Patch& patch) {
                const std::uint32_t other = patch.triangles[patch.samples - 1];
                return other == hit->triangle || share_corner(triangles[other], triangles[hit->triangle]);
            };
            std::size_t own = 0;
            while (own < count && !same(patches[own])) ++own;
            if (own == count) patches[count++].samples = 0;
            patches[own].add(hit->triangle, glm::vec2(offsets[s]));
        }
        coverage[i - first] = weight * static_cast<float>(covered);
        for (const Patch& patch : std::span(patches).first(count)) {
            whole.push_back(point_of(patch, input, i, range));
            const std::size_t sides = lit ? divide(patch, input.geometry, bent) : 1;
            whole.back().bent = sides > 1;
            for (std::size_t side = 0; sides > 1 && side < sides; ++side)
                parts.push_back(point_of(bent[side], input, i, range));
        }
    }
    for (std::vector<PixelPoint>* const list : {&whole, &parts})
        if (!std::ranges::is_sorted(*list, {}, &PixelPoint::group))
            std::ranges::stable_sort(*list, {}, &PixelPoint::group);
}

void TexturedPixels::find(const SpatialVariation& variation, bool back, bool mirrors, const TextureView& view,
                          std::span<const std::uint32_t> triangles, std::span<LaneSurface> surfaces) {
    const std::size_t layers = variation.layers.size();
    weights_.resize(surfaces.size() * layers);
    Block block(variation, back, view);
    for (std::size_t b = 0; b < surfaces.size(); ++b) {
        const std::span own = triangles.subspan(b * kLanes, std::min(kLanes, triangles.size() - b * kLanes));
        block.set(own, view.views.subspan(b * kLanes, own.size()), surfaces[b]);
        const std::span weights = std::span(weights_).subspan(b * layers, layers);
        variation.weights(block.points, weights);
        for (std::size_t i = 0; i < kLanes && variation.rotation.any(); ++i)
            surfaces[b].tangents[i] = block.tangent(variation.rotation, i);
        if (variation.normal.kind == NormalVariation::Kind::none) continue;
        surfaces[b].unperturbed = surfaces[b].normals;
        if (mirrors) block.find_parts(surfaces[b]);
        LaneVectors turned = block.normals;
        block.turn(turned);
        for (std::size_t i = 0; i < kLanes; ++i) surfaces[b].normals[i] = vector_at(turned, i);
    }
}

glm::dvec2 PixelPoint::on_image_plane(const Projection& projection, int width, int height) const {
    const auto columns = static_cast<std::uint32_t>(width);
    const std::uint32_t column = pixel % columns, row = pixel / columns;
    return nicol::on_image_plane(projection, width, height, column + 0.5 + static_cast<double>(at.x),
                                 row + 0.5 + static_cast<double>(at.y));
}

SurfacePoint surface_point(const TransferInput& input, std::uint32_t triangle, std::size_t pixel,
                           std::size_t& range) {
    const glm::uvec3& corners = input.geometry.triangles[triangle];
    const std::vector<VertexRange>& ranges = input.geometry.ranges;
    if (corners.x < ranges[range].first || corners.x >= ranges[range].last)
        range = range_of(input.geometry, corners.x);
    const bool occluded = input.visibility != nullptr && !(input.visibility->unoccluded(corners.x) &&
                                                           input.visibility->unoccluded(corners.y) &&
                                                           input.visibility->unoccluded(corners.z));
    return {.range = static_cast<std::uint32_t>(range),
            .occluded = occluded ? 1U : 0U,
            .triangle = triangle,
            .pixel = static_cast<std::uint32_t>(pixel)};
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
    for (const RayPoint& point : of_group) ray_views_.push_back(point.view);
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
    textures_.find(*range.material->variation(), is_back(input.geometry, range), mirrors,
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
