// SPDX-License-Identifier: MIT
#include "render/cpu/pixel_lights.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <vector>

#include "shading/shine.hpp"

namespace nicol {
namespace {

glm::vec3 facet_of(const WorldGeometry& geometry, std::uint32_t triangle, const glm::vec3& otherwise) {
    const glm::uvec3& t = geometry.triangles[triangle];
    const glm::vec3& corner = geometry.positions[t.x];
    const glm::vec3 normal = glm::cross(geometry.positions[t.y] - corner, geometry.positions[t.z] - corner);
    const float length = glm::length(normal);
    return length > 0 ? normal / length : otherwise;
}

bool turns_normals(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    return variation != nullptr && variation->normal.kind != NormalVariation::Kind::none;
}

std::vector<const Material*> layers_of(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    if (variation == nullptr) return {&material};
    std::vector<const Material*> out;
    for (const MaterialLayer& layer : variation->layers) out.push_back(layer.material.get());
    return out;
}

}  // namespace

std::uint64_t PixelLights::add(const VertexRange& range, const PixelPoints& points,
                               std::span<const std::span<glm::vec4>> out) const {
    const std::vector<const Material*> layers = layers_of(*range.material);
    const bool turned = turns_normals(*range.material);
    std::uint64_t rays = 0;
    std::vector<std::span<glm::vec4>> channels(out.size());
    for (std::size_t first = 0; first < points.pixels.size(); first += kLanes) {
        const std::size_t count = std::min(kLanes, points.pixels.size() - first);
        const LaneSurface& surface = points.surfaces[first / kLanes];
        std::array<glm::vec3, kLanes> facets, origins;
        for (std::size_t i = 0; i < count; ++i) {
            facets[i] = facet_of(input_.geometry, points.triangles[first + i], surface.normals[i]);
            origins[i] = surface.positions[i] + lights_.offset() * facets[i];
        }
        std::span<const LayerWeights> weights;
        if (!points.weights.empty())
            weights = points.weights.subspan(first / kLanes * layers.size(), layers.size());
        for (std::size_t c = 0; c < out.size(); ++c) channels[c] = out[c].subspan(first, count);
        const std::span of_facets = std::span(facets).first(count);
        rays += lights_.lighting().add(input_.view,
                                       {.positions = std::span(surface.positions).first(count),
                                        .normals = std::span(surface.normals).first(count),
                                        .facets = turned ? of_facets : std::span<glm::vec3>(),
                                        .origins = std::span(origins).first(count),
                                        .seeds = points.pixels.subspan(first, count),
                                        .shadowed = points.shadowed},
                                       {.layers = layers, .weights = weights}, channels);
        if (range.emission != nullptr) add_emission(range, points, first, channels);
    }
    return rays;
}

void PixelLights::add_emission(const VertexRange& range, const PixelPoints& points, std::size_t first,
                               std::span<const std::span<glm::vec4>> out) const {
    const LaneSurface& surface = points.surfaces[first / kLanes];
    const std::size_t count = out.front().size();
    std::array<glm::vec2, kLanes> texcoords{};
    if (range.emission->texture != nullptr) {
        for (std::size_t i = 0; i < count; ++i) {
            const std::array<glm::vec2, 3>& corners = input_.geometry.texcoords[points.triangles[first + i]];
            for (std::size_t k = 0; k < 3; ++k) texcoords[i] += surface.weights[k][i] * corners[k];
        }
    }
    add_shine(*range.emission, lights_.axis_of(range.instance), input_.view,
              std::span(surface.positions).first(count), std::span(surface.normals).first(count),
              std::span(texcoords).first(count), out);
}

}  // namespace nicol
