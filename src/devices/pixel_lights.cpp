// SPDX-License-Identifier: MIT
#include "devices/pixel_lights.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "devices/mirrored_parts.hpp"
#include "draw/visibility_buffer.hpp"
#include "geometry/ray_scene.hpp"
#include "material/followed_terms.hpp"
#include "material/sampled_terms.hpp"
#include "methods/bounces.hpp"
#include "shading/bounced_light.hpp"
#include "shading/emission.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/lane_triangles.hpp"
#include "surfaces/smooth_surfaces.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {
namespace {

std::array<glm::vec3, 3> corners_at(const LaneTriangles& triangles, std::size_t i) {
    return {vector_at(triangles.corners[0], i), vector_at(triangles.corners[1], i),
            vector_at(triangles.corners[2], i)};
}

LaneVectors in_lanes(const std::array<glm::vec3, kLanes>& from) {
    LaneVectors out;
    for (std::size_t i = 0; i < kLanes; ++i) put(out, i, from[i]);
    return out;
}

std::vector<const Material*> layers_of(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return {&material};
    std::vector<const Material*> out;
    for (const MaterialLayer& layer : variation->layers) out.push_back(layer.material.get());
    return out;
}

}  // namespace

LightingTally PixelLights::add(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out) const {
    const std::span points = batch.points();
    const SurfacePoint& any = points.front();
    const VertexRange& range = input_.geometry.ranges[any.range];
    const bool shadowed = range.roles.receives_shadows && (input_.visibility == nullptr || any.occluded != 0);
    const std::vector<const Material*> layers = layers_of(*range.material);
    const bool anisotropic = range.material->anisotropic() && !input_.geometry.texcoords.empty();
    const SpatialVariation* const variation = range.material->variation();
    const bool turned = variation != nullptr && variation->normal.kind != NormalVariation::Kind::none;
    const bool dimmed = turned && variation->normal.shadowed;
    const bool mirrors = !batch.in_pixels().empty() && lighting_.needs_pixels(*range.material);
    const bool casts = lighting_.needs_origins(shadowed);
    const bool spread = casts && !batch.in_pixels().empty() && shadowed;
    std::optional<BouncedLight> bounced;
    const bool followed = input_.smooth != nullptr && input_.smooth->of(any.triangle) == Smoothness::lobes;
    if (input_.bounced != nullptr && shadowed && !followed && batch.bounces() &&
        any_sampled(*range.material, lighting_.sampled()))
        bounced.emplace(input_.bounced->layout(), input_.bounced->rows());
    LightingTally tally;
    std::vector<std::span<glm::vec4>> channels(out.size());
    const bool rotated = variation != nullptr && variation->rotation.any();
    const bool own_tangents = !input_.geometry.tangents.empty();
    for (std::size_t first = 0; first < points.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, points.size() - first);
        const LaneSurface& surface = batch.surfaces()[first / kLanes];
        std::array<std::uint32_t, kLanes> shown;
        for (std::size_t i = 0; i < count; ++i) shown[i] = points[first + i].triangle;
        const std::span triangles = std::span(shown).first(count);
        const LaneTriangles corners = LaneTriangles::of(input_.geometry, triangles);
        const LaneVectors normals = in_lanes(surface.normals);
        const LaneVectors facets = corners.facets(normals);
        std::array<glm::vec3, kLanes> of_facets, origins, tangents;
        std::array<PixelOrigins::Part, kLanes> in_pixels;
        std::array<Corners, kLanes> of_triangles;
        std::array<std::uint32_t, kLanes> seeds;
        for (std::size_t i = 0; i < count; ++i) {
            of_facets[i] = vector_at(facets, i);
            of_triangles[i] = input_.geometry.triangles[shown[i]];
            if (casts) {
                const glm::vec3 lift = static_cast<float>(ray_offset(corners_at(corners, i))) * of_facets[i];
                origins[i] = surface.positions[i] + lift;
                if (spread) in_pixels[i] = part_of(batch.in_pixels()[first + i], of_triangles[i], lift);
            }
            seeds[i] = sample_seed(points[first + i].pixel, input_.seed);
        }
        MirroredPixels mirrored;
        std::array<MirroredParts, kLanes> parts;
        if (mirrors) {
            find_mirrored(batch.in_pixels().subspan(first, count),
                          {.triangles = corners,
                           .facets = facets,
                           .positions = std::span(surface.positions).first(count),
                           .normals = normals},
                          mirrored);
            for (std::size_t i = 0; i < count && turned; ++i) parts[i] = parts_at(surface, i, mirrored);
        }
        if (anisotropic && rotated) {
            tangents = surface.tangents;
        } else if (anisotropic && own_tangents) {
            for (std::size_t i = 0; i < count; ++i)
                tangents[i] = tangent(input_.geometry, shown[i],
                                      {surface.weights[0][i], surface.weights[1][i], surface.weights[2][i]});
        } else if (anisotropic) {
            const LaneVectors along = texture_tangents(input_.geometry, triangles, corners,
                                                       turned ? in_lanes(surface.unperturbed) : normals);
            for (std::size_t i = 0; i < count; ++i) tangents[i] = vector_at(along, i);
        }
        std::span<const LayerWeights> weights;
        if (!batch.weights().empty())
            weights = batch.weights().subspan(first / kLanes * layers.size(), layers.size());
        for (std::size_t c = 0; c < out.size(); ++c) channels[c] = out[c].subspan(first, count);
        if (bounced) bounced->take(std::span(of_triangles).first(count), surface.weights);
        PixelOrigins places(input_.projection.view, input_.geometry.positions, input_.geometry.normals,
                            std::span(in_pixels).first(count));
        tally += lighting_.add(batch.views().subspan(first, count),
                               {.positions = std::span(surface.positions).first(count),
                                .normals = std::span(surface.normals).first(count),
                                .tangents = std::span(tangents).first(anisotropic ? count : 0),
                                .facets = std::span(of_facets).first(turned ? count : 0),
                                .unperturbed = std::span(surface.unperturbed).first(dimmed ? count : 0),
                                .origins = std::span(origins).first(casts ? count : 0),
                                .mirrored = mirrors ? &mirrored : nullptr,
                                .parts = std::span(parts).first(mirrors && turned ? count : 0),
                                .places = spread ? &places : nullptr,
                                .bounced = bounced ? &*bounced : nullptr,
                                .seeds = std::span(seeds).first(count),
                                .noise_factors = batch.noise_factors().subspan(first, count),
                                .shadowed = shadowed,
                                .rays_pass_glass = followed && shadowed && batch.bounces() &&
                                                   all_followed_sampled(lighting_.sampled()),
                                .receives_shadows = range.roles.receives_shadows},
                               {.layers = layers, .weights = weights}, channels);
    }
    return tally;
}

void PixelLights::find_mirrored(std::span<const PixelPoint> points, const ShownPoints& shown,
                                MirroredPixels& out) const {
    const int width = input_.hits.width(), height = input_.hits.height();
    LaneSamples samples;
    for (std::size_t i = 0; i < kLanes; ++i) {
        // The point stands for its part of the pixel.
        const PixelPoint& point = points[i < points.size() ? i : 0];
        const glm::vec2 place(point.on_image_plane(input_.projection, width, height));
        samples.right[i] = place.x;
        samples.up[i] = place.y;
        samples.width[i] = point.size.x;
        samples.height[i] = point.size.y;
    }
    mirrored_pixels(input_.projection, width, height, shown, samples, out);
}

PixelOrigins::Part PixelLights::part_of(const PixelPoint& point, const Corners& triangle,
                                        const glm::vec3& lift) const {
    const Projection& projection = input_.projection;
    const int width = input_.hits.width(), height = input_.hits.height();
    const glm::dvec2 sample = 2 * projection.sample_size *
                              glm::dvec2(projection.half_width / width, projection.half_height / height);
    return {.triangle = triangle,
            .middle = glm::vec2(point.on_image_plane(projection, width, height)),
            .size = point.size * glm::vec2(sample),
            .lift = lift,
            .pixel = point.pixel};
}

MirroredParts PixelLights::parts_at(const LaneSurface& surface, std::size_t lane,
                                    MirroredPixels& pixels) const {
    std::array<glm::vec3, MirroredParts::kCount> normals;
    for (std::size_t part = 0; part < normals.size(); ++part)
        normals[part] = vector_at(surface.parts[part], lane);
    const glm::dvec3 sight = -input_.projection.view.towards(glm::dvec3(surface.positions[lane]));
    MirroredPixel pixel = pixels.at(lane);
    const MirroredParts out = mirrored_parts(glm::vec3(sight), surface.normals[lane], normals, pixel);
    put(pixels, lane, pixel);
    return out;
}

void PixelLights::add_emission(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out) const {
    const VertexRange& range = input_.geometry.ranges[batch.points().front().range];
    if (range.emission == nullptr || !batch.emits()) return;
    const WorldGeometry& geometry = input_.geometry;
    std::vector<std::span<glm::vec4>> channels(out.size());
    for (std::size_t first = 0; first < batch.points().size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, batch.points().size() - first);
        const LaneSurface& surface = batch.surfaces()[first / kLanes];
        std::array<TexturePoint, kLanes> points;
        for (std::size_t i = 0; i < count && range.emission->texture != nullptr; ++i) {
            const std::uint32_t triangle = batch.points()[first + i].triangle;
            points[i] = texture_point({surface.weights[0][i], surface.weights[1][i], surface.weights[2][i]},
                                      geometry.texcoords.empty() ? nullptr : &geometry.texcoords[triangle],
                                      geometry.colors.empty() ? nullptr : &geometry.colors[triangle]);
        }
        for (std::size_t c = 0; c < out.size(); ++c) channels[c] = out[c].subspan(first, count);
        add_emitted(*range.emission, input_.local_lights->axis_of(range.instance),
                    batch.views().subspan(first, count), std::span(surface.positions).first(count),
                    std::span(surface.normals).first(count), std::span(points).first(count), channels);
    }
}

}  // namespace nicol
