// SPDX-License-Identifier: MIT
#include "devices/pixel_lights.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "devices/mirrored_parts.hpp"
#include "draw/visibility_buffer.hpp"
#include "geometry/ray_scene.hpp"
#include "material/sampled_terms.hpp"
#include "methods/bounces.hpp"
#include "shading/bounced_light.hpp"
#include "shading/emission.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {
namespace {

// Returns the vectors of vertices at the corners of a triangle.
std::array<glm::vec3, 3> corners_of(std::span<const glm::vec3> vectors, const glm::uvec3& triangle) {
    return {vectors[triangle.x], vectors[triangle.y], vectors[triangle.z]};
}

glm::vec3 facet_of(const std::array<glm::vec3, 3>& corners, const glm::vec3& otherwise) {
    // Double precision, because squares of very small or large edges exceed the range of floats.
    const glm::dvec3 corner(corners[0]);
    const glm::dvec3 normal = glm::cross(glm::dvec3(corners[1]) - corner, glm::dvec3(corners[2]) - corner);
    const double length = glm::length(normal);
    return length > 0 ? glm::vec3(normal / length) : otherwise;
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
    const bool shadowed = input_.visibility == nullptr || any.occluded != 0;
    const std::vector<const Material*> layers = layers_of(*range.material);
    const bool anisotropic = range.material->anisotropic() && !input_.geometry.texcoords.empty();
    const SpatialVariation* const variation = range.material->variation();
    const bool turned = variation != nullptr && variation->normal.kind != NormalVariation::Kind::none;
    const bool dimmed = turned && variation->normal.shadowed;
    const bool mirrors = !batch.in_pixels().empty() && lights_.lighting().needs_pixels(*range.material);
    const bool spread = !batch.in_pixels().empty() && shadowed;
    std::optional<BouncedLight> bounced;
    if (input_.bounced != nullptr && shadowed && any_sampled(*range.material, lights_.lighting().sampled()))
        bounced.emplace(input_.bounced->layout(), input_.bounced->rows());
    LightingTally tally;
    std::vector<std::span<glm::vec4>> channels(out.size());
    for (std::size_t first = 0; first < points.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, points.size() - first);
        const LaneSurface& surface = batch.surfaces()[first / kLanes];
        std::array<glm::vec3, kLanes> facets, origins, tangents;
        std::array<PixelOrigins::Part, kLanes> in_pixels;
        std::array<Corners, kLanes> triangles;
        std::array<MirroredPixel, kLanes> mirrored;
        std::array<MirroredParts, kLanes> parts;
        std::array<std::uint32_t, kLanes> seeds;
        for (std::size_t i = 0; i < count; ++i) {
            const glm::uvec3& triangle = input_.geometry.triangles[points[first + i].triangle];
            const std::array corners = corners_of(input_.geometry.positions, triangle);
            facets[i] = facet_of(corners, surface.normals[i]);
            triangles[i] = triangle;
            const glm::vec3 lift = static_cast<float>(ray_offset(corners)) * facets[i];
            origins[i] = surface.positions[i] + lift;
            if (spread) in_pixels[i] = part_of(batch.in_pixels()[first + i], triangle, lift);
            seeds[i] = sample_seed(points[first + i].pixel, input_.seed);
            if (mirrors)
                mirrored[i] = mirrored_at(batch.in_pixels()[first + i], surface, i,
                                          {.corners = corners,
                                           .normals = corners_of(input_.geometry.normals, triangle),
                                           .facet = facets[i]});
            if (mirrors && turned) parts[i] = parts_at(surface, i, mirrored[i]);
            if (!anisotropic) continue;
            if (variation != nullptr && variation->rotation.any()) {
                tangents[i] = surface.tangents[i];
                continue;
            }
            const glm::vec3 weights(surface.weights[0][i], surface.weights[1][i], surface.weights[2][i]);
            tangents[i] = tangent(input_.geometry, points[first + i].triangle, weights);
        }
        std::span<const LayerWeights> weights;
        if (!batch.weights().empty())
            weights = batch.weights().subspan(first / kLanes * layers.size(), layers.size());
        for (std::size_t c = 0; c < out.size(); ++c) channels[c] = out[c].subspan(first, count);
        const std::span of_facets = std::span(facets).first(count);
        if (bounced) bounced->take(std::span(triangles).first(count), surface.weights);
        PixelOrigins places(input_.projection.view, input_.geometry.positions, input_.geometry.normals,
                            std::span(in_pixels).first(count));
        tally +=
            lights_.lighting().add(batch.views().subspan(first, count),
                                   {.positions = std::span(surface.positions).first(count),
                                    .normals = std::span(surface.normals).first(count),
                                    .tangents = std::span(tangents).first(anisotropic ? count : 0),
                                    .facets = turned ? of_facets : std::span<glm::vec3>(),
                                    .unperturbed = std::span(surface.unperturbed).first(dimmed ? count : 0),
                                    .origins = std::span(origins).first(count),
                                    .mirrored = std::span(mirrored).first(mirrors ? count : 0),
                                    .parts = std::span(parts).first(mirrors && turned ? count : 0),
                                    .places = spread ? &places : nullptr,
                                    .bounced = bounced ? &*bounced : nullptr,
                                    .seeds = std::span(seeds).first(count),
                                    .shadowed = shadowed},
                                   {.layers = layers, .weights = weights}, channels);
        if (range.emission != nullptr && batch.emits()) add_emission(range, batch, first, channels);
    }
    return tally;
}

MirroredPixel PixelLights::mirrored_at(const PixelPoint& point, const LaneSurface& surface, std::size_t lane,
                                       const ShownTriangle& triangle) const {
    const int width = input_.hits.width(), height = input_.hits.height();
    MirroredPixel out =
        mirrored_pixel(input_.projection, width, height, triangle, surface.positions[lane],
                       surface.normals[lane], point.on_image_plane(input_.projection, width, height));
    // The point stands for its part of the pixel.
    out.steps[0] *= point.size.x;
    out.steps[1] *= point.size.y;
    return out;
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
                                    MirroredPixel& pixel) const {
    std::array<glm::vec3, MirroredParts::kCount> normals;
    for (std::size_t part = 0; part < normals.size(); ++part)
        normals[part] = vector_at(surface.parts[part], lane);
    const glm::dvec3 sight = -input_.projection.view.towards(glm::dvec3(surface.positions[lane]));
    return mirrored_parts(glm::vec3(sight), surface.normals[lane], normals, pixel);
}

void PixelLights::add_emission(const VertexRange& range, const PixelBatch& batch, std::size_t first,
                               std::span<const std::span<glm::vec4>> out) const {
    const LaneSurface& surface = batch.surfaces()[first / kLanes];
    const std::size_t count = out.front().size();
    std::array<glm::vec2, kLanes> texcoords{};
    if (range.emission->texture != nullptr) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::array<glm::vec2, 3>& corners =
                input_.geometry.texcoords[batch.points()[first + i].triangle];
            for (std::size_t k = 0; k < 3; ++k) texcoords[i] += surface.weights[k][i] * corners[k];
        }
    }
    add_emitted(*range.emission, lights_.axis_of(range.instance), batch.views().subspan(first, count),
                std::span(surface.positions).first(count), std::span(surface.normals).first(count),
                std::span(texcoords).first(count), out);
}

}  // namespace nicol
