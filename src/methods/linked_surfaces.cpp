// SPDX-License-Identifier: MIT
#include "methods/linked_surfaces.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <tuple>
#include <utility>

#include "material/sampled_terms.hpp"
#include "material/spatial_variation.hpp"
#include "methods/lobe_photons.hpp"
#include "shading/channel_spans.hpp"
#include "shading/light_samples.hpp"
#include "surfaces/plain_materials.hpp"
#include "surfaces/tangents.hpp"
#include "surfaces/triangle_point.hpp"

namespace nicol {
namespace {

// Light samples for a wide light at the end of a link. A vertex has many links, which share the noise.
constexpr std::uint32_t kLinkLightSamples = 1;

// Sets lane i of the points to where a link ends. Textures have no footprint there.
void put_point(const WorldGeometry& geometry, const SurfaceLink& link, std::size_t i, TexturePoints& points) {
    const TexturePoint at = texture_point(geometry, link.triangle, corner_weights(link));
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

/// Terms of a material's layers whose lobes are wide enough for links.
class LayersOf {
public:
    /// has(layer, term): whether a term is to be among them.
    template <class Has>
    LayersOf(const MaterialPtr& material, const Has& has) {
        for (const MaterialPtr& layer : plain_materials(material)) {
            terms_.push_back(some_terms(layer, [&](int term) {
                const bool both = has(*layer, term) && layer->isotropic().lobe_width(term) >= kNarrowestLobe;
                any_ |= both;
                return both;
            }));
            layers_.push_back(terms_.back().get());
        }
    }

    [[nodiscard]] bool any() const { return any_; }
    [[nodiscard]] std::span<const Material* const> layers() const { return layers_; }

private:
    std::vector<MaterialPtr> terms_;
    std::vector<const Material*> layers_;
    bool any_ = false;
};

// Returns a number from 0 to 1 that depends on the link and the purpose as if by chance.
float chance(std::size_t link, std::uint64_t purpose) {
    std::uint64_t x = (2 * std::uint64_t{link} + purpose + 1) * 0x9e3779b97f4a7c15U;
    x = (x ^ x >> 32U) * 0xd6e8feb86659fd93U;
    return static_cast<float>(x >> 40U) * 0x1p-24F;
}

// Chooses one of several shares, whose sum is at most 1, with their probabilities.
template <class Shares>
std::size_t chosen(const Shares& shares, std::size_t count, float at) {
    std::size_t k = 0;
    for (; k + 1 < count && at >= shares[static_cast<int>(k)]; ++k) at -= shares[static_cast<int>(k)];
    return k;
}

}  // namespace

LinkedSurfaces::LinkedSurfaces(const WorldGeometry& geometry, Receivers receivers)
    : receivers_(std::move(receivers)) {
    std::vector<SurfaceLink>& links = receivers_.links;
    const auto range_at = [&](const SurfaceLink& link) {
        return static_cast<std::uint32_t>(range_of(geometry, geometry.triangles[link.triangle].x));
    };
    for (std::size_t begin = 0; begin < links.size();) {
        const std::uint32_t block = links[begin].receiver / kLanes;
        std::vector<std::pair<std::uint32_t, SurfaceLink>> sorted;
        for (std::size_t k = begin; k < links.size() && links[k].receiver / kLanes == block; ++k)
            sorted.emplace_back(range_at(links[k]), links[k]);
        const auto coarse = [](const SurfaceLink& link) { return link.coarse_solid_angle > 0; };
        // Links in equal directions end close to each other, so that they use the same memory.
        std::ranges::stable_sort(sorted, {}, [&](const auto& pair) {
            return std::tuple(!coarse(pair.second), pair.first, pair.second.direction);
        });
        firsts_.resize(block + 1, batches_.size());
        coarse_.resize(block + 1);
        for (std::size_t k = 0; k < sorted.size(); ++k) {
            const std::uint32_t range = sorted[k].first;
            links[begin + k] = sorted[k].second;
            if (k == 0 || batches_.back().range != range || batches_.back().count == kLanes ||
                coarse(sorted[k].second) != coarse(sorted[k - 1].second)) {
                batches_.push_back({.range = range, .count = 0, .first = begin + k});
                if (coarse(sorted[k].second)) ++coarse_[block];
            }
            ++batches_.back().count;
        }
        begin += sorted.size();
    }
    firsts_.resize(blocks() + 1, batches_.size());
    coarse_.resize(blocks());
    ends_.reserve(links.size());
    for (std::size_t k = 0; k < links.size(); ++k) {
        const std::size_t corner = chosen(corner_weights(links[k]), 3, chance(k, 0));
        const Receivers::Blend& blend =
            receivers_.blends[geometry.triangles[links[k].triangle][static_cast<glm::length_t>(corner)]];
        const std::size_t one = chosen(blend.weights, blend.weights.size(), chance(k, 1));
        ends_.push_back(blend.weights[one] > 0 ? blend.receivers[one] : kNoVertex);
    }
}

void LinkedSurfaces::find_weights(const WorldGeometry& geometry) {
    weights_.clear();
    first_weights_.clear();
    grey_ = true;
    for (const Batch& batch : batches_) {
        first_weights_.push_back(weights_.size());
        const SpatialVariation* const variation = geometry.ranges[batch.range].material->variation();
        if (variation == nullptr) continue;
        TexturePoints points{};
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t k = std::min(i, std::size_t{batch.count} - 1);
            put_point(geometry, links()[batch.first + k], i, points);
        }
        weights_.resize(weights_.size() + variation->layers.size());
        variation->weights(points, std::span(weights_).subspan(first_weights_.back()));
    }
    first_weights_.push_back(weights_.size());
    for (const LayerWeights& weights : weights_)
        if (weights.points != 0 && !weights.equal) grey_ = false;
}

std::span<const LayerWeights> LinkedSurfaces::weights(const Batch& batch) const {
    const auto number = static_cast<std::size_t>(&batch - batches_.data());
    return std::span(weights_).subspan(first_weights_[number],
                                       first_weights_[number + 1] - first_weights_[number]);
}

std::size_t LinkedSurfaces::bytes() const noexcept {
    return links().size() * (sizeof(SurfaceLink) + sizeof(std::uint32_t)) +
           blends().size() * sizeof(Receivers::Blend) + receivers() * sizeof(std::uint32_t) +
           batches_.size() * (sizeof(Batch) + 2 * sizeof(std::size_t)) +
           weights_.size() * sizeof(LayerWeights);
}

BakeGeometry link_geometry(const WorldGeometry& geometry) {
    return {.positions = geometry.positions,
            .normals = geometry.normals,
            .triangles = geometry.triangles,
            .present = presence_of(geometry)};
}

TriangleSides sides_of(const WorldGeometry& geometry) {
    TriangleSides out;
    for (const TriangleBatch& batch : triangle_batches(geometry)) {
        const bool back = batch.two_sided && is_back(geometry, geometry.ranges[batch.range]);
        std::vector<std::uint32_t>& to = back ? out.backs : out.fronts;
        for (std::size_t t = batch.first; t < batch.last; ++t) to.push_back(static_cast<std::uint32_t>(t));
    }
    return out;
}

glm::vec3 normal_at_end(const WorldGeometry& geometry, const SurfaceLink& link, const glm::vec3& direction) {
    return normalized_or(
        interpolated(geometry.normals, geometry.triangles[link.triangle], corner_weights(link)), -direction);
}

Viewpoint link_frames() {
    return {.eye = {0, 0, 0}, .forward = {0, 1, 0}, .up = {0, 0, 1}, .right = {1, 0, 0}};
}

LightingTally reflect_lights(const WorldGeometry& geometry, const DirectionSet& directions,
                             const LinkedSurfaces& surfaces, const LinkedSurfaces::Batch& batch,
                             const LocalLighting& lighting, LinkStokes& out) {
    const MaterialPtr& material = geometry.ranges[batch.range].material;
    // Photons carry what narrow lobes reflect of lamps.
    const LayersOf lit(material, [](const Material& layer, int term) { return !sends_photons(layer, term); });
    const bool anisotropic = material->anisotropic() && !geometry.texcoords.empty();
    constexpr std::size_t most = kLanes;
    const std::size_t count = batch.count;
    std::array<glm::vec3, most> positions, normals, tangents, origins;
    std::array<std::uint32_t, most> seeds;
    std::array<Viewpoint, most> views;
    for (std::size_t i = 0; i < count; ++i) {
        const SurfaceLink& link = surfaces.links()[batch.first + i];
        const glm::uvec3& triangle = geometry.triangles[link.triangle];
        const glm::vec3 weights = corner_weights(link);
        const std::array corners{geometry.positions[triangle.x], geometry.positions[triangle.y],
                                 geometry.positions[triangle.z]};
        const glm::vec3 facet(glm::normalize(glm::cross(glm::dvec3(corners[1]) - glm::dvec3(corners[0]),
                                                        glm::dvec3(corners[2]) - glm::dvec3(corners[0]))));
        positions[i] = interpolated(geometry.positions, triangle, weights);
        normals[i] = normalized_or(interpolated(geometry.normals, triangle, weights), facet);
        origins[i] = positions[i] + static_cast<float>(ray_offset(corners)) * facet;
        if (anisotropic) tangents[i] = tangent(geometry, link.triangle, weights);
        seeds[i] = sample_seed(static_cast<std::uint32_t>(batch.first + i), 0);
        views[i] = link_frames();
        views[i].orthographic = true;
        views[i].forward = directions.directions()[link.direction];
    }
    thread_local std::vector<glm::vec4> sums;
    sums.clear();
    const std::vector<std::span<glm::vec4>> channels = channel_spans(sums, out.size(), count);
    const Views seen{std::span(views).first(count)};
    const LitPoints points{.positions = std::span(positions).first(count),
                           .normals = std::span(normals).first(count),
                           .tangents = std::span(tangents).first(anisotropic ? count : 0),
                           .origins = std::span(origins).first(count),
                           .seeds = std::span(seeds).first(count),
                           .shadowed = true};
    LightingTally tally = lighting.add_lights(seen, points, {lit.layers(), surfaces.weights(batch)},
                                              kLinkLightSamples, channels);
    if (lighting.any_focused()) {  // light that glass and mirrors focus, of which photons carry nothing
        const LayersOf narrow(material, sends_photons);
        if (narrow.any())
            tally +=
                lighting.add_lights(seen, points, {narrow.layers(), surfaces.weights(batch)}, 0, channels);
    }
    for (std::size_t c = 0; c < out.size(); ++c) std::ranges::copy(channels[c], &out[c][batch.first]);
    return tally;
}

}  // namespace nicol
