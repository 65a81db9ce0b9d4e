// SPDX-License-Identifier: MIT
#include "methods/linked_light.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <numeric>

#include "material/sampled_terms.hpp"
#include "material/spatial_variation.hpp"
#include "shading/channel_spans.hpp"
#include "shading/light_samples.hpp"
#include "simd/lane_transpose.hpp"
#include "surfaces/plain_materials.hpp"
#include "surfaces/tangents.hpp"

namespace nicol {
namespace {

constexpr std::size_t kMost = LinkedSurfaces::Batch::kMost;

// Light samples for a wide light at the end of a link. A vertex has many links, which share the noise.
constexpr std::uint32_t kLinkLightSamples = 1;

constexpr std::array<std::uint8_t, kMost> kAll = [] {
    std::array<std::uint8_t, kMost> all{};
    all.fill(1);
    return all;
}();

glm::vec3 weights_of(const SurfaceLink& link) {
    return {1 - link.b1 - link.b2, link.b1, link.b2};
}

// Sets lane i of the points to where a link ends. Textures have no footprint there.
void put_point(const WorldGeometry& geometry, const SurfaceLink& link, std::size_t i, TexturePoints& points) {
    const TexturePoint at = texture_point(
        weights_of(link), geometry.texcoords.empty() ? nullptr : &geometry.texcoords[link.triangle],
        geometry.colors.empty() ? nullptr : &geometry.colors[link.triangle]);
    for (glm::length_t k = 0; k < 2; ++k) points.uv[static_cast<std::size_t>(k)][i] = at.uv[k];
    for (glm::length_t k = 0; k < 3; ++k) points.color[static_cast<std::size_t>(k)][i] = at.color[k];
}

// Sum of the values at a triangle's corners, each times its weight.
glm::vec3 interpolated(std::span<const glm::vec3> values, const glm::uvec3& corners,
                       const glm::vec3& weights) {
    return weights.x * values[corners.x] + weights.y * values[corners.y] + weights.z * values[corners.z];
}

glm::vec3 normalized_or(const glm::vec3& v, const glm::vec3& otherwise) {
    const float length = glm::length(v);
    return length > 1e-6F ? v / length : otherwise;
}

}  // namespace

LinkedSurfaces::LinkedSurfaces(const WorldGeometry& geometry, std::vector<SurfaceLink> links)
    : links_(std::move(links)), firsts_(geometry.positions.size() + 1, 0), numbers_(links_.size()) {
    std::vector<std::uint32_t> ranges;
    ranges.reserve(links_.size());
    for (const SurfaceLink& link : links_) {
        ++firsts_[link.vertex + 1];
        ranges.push_back(static_cast<std::uint32_t>(range_of(geometry, geometry.triangles[link.triangle].x)));
    }
    std::partial_sum(firsts_.begin(), firsts_.end(), firsts_.begin());
    std::iota(numbers_.begin(), numbers_.end(), 0U);
    std::ranges::stable_sort(numbers_, {}, [&](std::uint32_t link) { return ranges[link]; });
    for (std::size_t first = 0; first < numbers_.size();) {
        const std::uint32_t range = ranges[numbers_[first]];
        std::size_t count = 0;
        while (count < Batch::kMost && first + count < numbers_.size() &&
               ranges[numbers_[first + count]] == range)
            ++count;
        batches_.push_back({.range = range, .first = first, .count = count, .weights = 0});
        first += count;
    }
}

void LinkedSurfaces::find_weights(const WorldGeometry& geometry) {
    weights_.clear();
    for (Batch& batch : batches_) {
        const SpatialVariation* const variation = geometry.ranges[batch.range].material->variation();
        batch.weights = weights_.size();
        if (variation == nullptr) continue;
        const std::size_t layers = variation->layers.size();
        const std::size_t blocks = (batch.count + kLanes - 1) / kLanes;
        weights_.resize(weights_.size() + blocks * layers);
        for (std::size_t b = 0; b < blocks; ++b) {
            TexturePoints points{};
            for (std::size_t i = 0; i < kLanes; ++i) {
                const std::size_t k = std::min(b * kLanes + i, batch.count - 1);
                put_point(geometry, links_[numbers(batch)[k]], i, points);
            }
            variation->weights(points, std::span(weights_).subspan(batch.weights + b * layers, layers));
        }
    }
}

Viewpoint link_frames() {
    return {.eye = {0, 0, 0}, .forward = {0, 1, 0}, .up = {0, 0, 1}, .right = {1, 0, 0}};
}

Bounce::Bounce(const WorldGeometry& geometry, const DirectionSet& directions, const LinkedSurfaces& surfaces,
               const std::map<MaterialPtr, ResponseTable>& tables, const LightLayout& layout)
    : geometry_(geometry),
      directions_(directions),
      surfaces_(surfaces),
      tables_(tables),
      shade_(layout, 1, static_cast<std::size_t>(layout.kind())),
      rotation_(layout),
      arriving_(layout, directions.directions(), link_frames()) {}

void Bounce::leave(const LinkedSurfaces::Batch& batch, const VertexLight& light, const LinkStokes& lit,
                   LinkStokes& out) const {
    thread_local VertexLight at_points;
    thread_local std::vector<glm::vec4> stokes;
    std::array<glm::vec3, kMost> sights, normals;
    const std::span numbers = surfaces_.numbers(batch);
    const std::size_t count = numbers.size();
    at_points.resize(shade_.layout(), light.channels(), kMost);
    for (std::size_t begin = 0; begin < count; begin += kLanes) {
        std::array<std::array<const float*, kLanes>, 3> rows;
        std::array<Lanes, 3> weights;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t point = std::min(begin + i, count - 1);
            const SurfaceLink& link = surfaces_.links()[numbers[point]];
            const glm::uvec3& corners = geometry_.triangles[link.triangle];
            const glm::vec3 shares = weights_of(link);
            for (glm::length_t k = 0; k < 3; ++k) {
                rows[static_cast<std::size_t>(k)][i] = light.row(corners[k]);
                weights[static_cast<std::size_t>(k)][i] = shares[k];
            }
            // Seen from the link's vertex, its end is somewhere along its direction.
            sights[point] = directions_.directions()[link.direction];
            normals[point] = normalized_or(interpolated(geometry_.normals, corners, shares), -sights[point]);
        }
        const std::size_t block = begin / kLanes;
        to_lanes_weighted(rows, weights, light.row_size(), at_points.block(block, 0).data());
        rotation_.into_frames(std::span(normals).subspan(begin, std::min(kLanes, count - begin)), at_points,
                              block);
    }
    const std::vector<std::span<glm::vec4>> channels = channel_spans(stokes, out.size(), count);
    const MaterialPtr& material = geometry_.ranges[batch.range].material;
    const std::span positions = std::span<const glm::vec3>(sights).first(count);
    if (const SpatialVariation* const variation = material->variation()) {
        std::vector<const ResponseTable*> layers;
        for (const MaterialLayer& layer : variation->layers) layers.push_back(&tables_.at(layer.material));
        shade_.run(layers, surfaces_.weights(batch), at_points, frames_, positions,
                   std::span(normals).first(count), channels);
    } else {
        shade_.run(tables_.at(material), at_points, frames_, positions, std::span(normals).first(count),
                   std::span(kAll).first(count), 0, count, channels);
    }
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < count; ++i) {
            glm::vec4& to = out[c][numbers[i]];
            to = lit.empty() ? channels[c][i] : channels[c][i] + lit[c][numbers[i]];
        }
}

LightingTally reflect_lights(const WorldGeometry& geometry, const DirectionSet& directions,
                             const LinkedSurfaces& surfaces, const LinkedSurfaces::Batch& batch,
                             const LocalLighting& lighting, LinkStokes& out) {
    const MaterialPtr& material = geometry.ranges[batch.range].material;
    // Mirrors and narrow lobes show a light in so few links that their vertices would be far too bright, and
    // all others too dark.
    std::vector<MaterialPtr> wide;
    std::vector<const Material*> layers;
    for (const MaterialPtr& layer : plain_materials(material)) {
        wide.push_back(in_harmonics(layer, SampledTerms::anisotropic_narrow));
        layers.push_back(wide.back().get());
    }
    const bool textured = material->variation() != nullptr;
    const bool anisotropic = material->anisotropic() && !geometry.texcoords.empty();
    const std::span numbers = surfaces.numbers(batch);
    LightingTally tally;
    for (std::size_t begin = 0; begin < numbers.size(); begin += kLanes) {
        const std::size_t count = std::min(kLanes, numbers.size() - begin);
        std::array<glm::vec3, kLanes> positions, normals, tangents, origins;
        std::array<std::uint32_t, kLanes> seeds;
        std::array<Viewpoint, kLanes> views;
        for (std::size_t i = 0; i < count; ++i) {
            const std::uint32_t number = numbers[begin + i];
            const SurfaceLink& link = surfaces.links()[number];
            const glm::uvec3& triangle = geometry.triangles[link.triangle];
            const glm::vec3 weights = weights_of(link);
            const std::array corners{geometry.positions[triangle.x], geometry.positions[triangle.y],
                                     geometry.positions[triangle.z]};
            const glm::vec3 facet(
                glm::normalize(glm::cross(glm::dvec3(corners[1]) - glm::dvec3(corners[0]),
                                          glm::dvec3(corners[2]) - glm::dvec3(corners[0]))));
            positions[i] = interpolated(geometry.positions, triangle, weights);
            normals[i] = normalized_or(interpolated(geometry.normals, triangle, weights), facet);
            origins[i] = positions[i] + static_cast<float>(ray_offset(corners)) * facet;
            if (anisotropic) tangents[i] = tangent(geometry, link.triangle, weights);
            seeds[i] = sample_seed(number, 0);
            views[i] = link_frames();
            views[i].orthographic = true;
            views[i].forward = directions.directions()[link.direction];
        }
        thread_local std::vector<glm::vec4> sums;
        sums.clear();
        const std::vector<std::span<glm::vec4>> channels = channel_spans(sums, out.size(), count);
        tally += lighting.add_lights(Views(std::span(views).first(count)),
                                     {.positions = std::span(positions).first(count),
                                      .normals = std::span(normals).first(count),
                                      .tangents = std::span(tangents).first(anisotropic ? count : 0),
                                      .facets = {},
                                      .unperturbed = {},
                                      .origins = std::span(origins).first(count),
                                      .mirrored = {},
                                      .parts = {},
                                      .seeds = std::span(seeds).first(count),
                                      .shadowed = true},
                                     {.layers = layers,
                                      .weights = textured ? surfaces.weights(batch).subspan(
                                                                begin / kLanes * layers.size(), layers.size())
                                                          : std::span<const LayerWeights>()},
                                     kLinkLightSamples, channels);
        for (std::size_t c = 0; c < out.size(); ++c)
            for (std::size_t i = 0; i < count; ++i) out[c][numbers[begin + i]] = channels[c][i];
    }
    return tally;
}

void Bounce::arrive(std::size_t block, const LinkStokes& stokes, VertexLight& out) const {
    const LightLayout& layout = shade_.layout();
    const std::size_t size = layout.size(), row_size = out.row_size();
    const std::size_t first = block * kLanes;
    const std::size_t count = std::min(kLanes, geometry_.positions.size() - first);
    thread_local std::vector<float> sums;
    sums.assign(kLanes * row_size, 0.0F);
    std::array<const float*, kLanes> rows;
    for (std::size_t i = 0; i < kLanes; ++i) {
        float* const row = sums.data() + i * row_size;
        rows[i] = row;
        if (i >= count) continue;
        std::size_t number = surfaces_.first_of(first + i);
        for (const SurfaceLink& link : surfaces_.links_of(first + i)) {
            for (std::size_t c = 0; c < stokes.size(); ++c)
                arriving_.add(link.direction, link.solid_angle, stokes[c][number], row + c * size);
            ++number;
        }
    }
    to_lanes(rows, row_size, out.block(block, 0).data());
    rotation_.into_frames(std::span(geometry_.normals).subspan(first, count), out, block);
    add_mirror_image(layout, out, block);
}

}  // namespace nicol
