// SPDX-License-Identifier: MIT
// Points of surfaces that pixels show.
#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <span>

#include "devices/pixel_batch.hpp"
#include "draw/visibility_buffer.hpp"
#include "material/followed_terms.hpp"
#include "material/spatial_variation.hpp"
#include "surfaces/local_lights.hpp"
#include "surfaces/smooth_surfaces.hpp"

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

// Divides a surface into its samples.
std::size_t divide(const Patch& patch, std::array<Patch, kMostPixelSamples>& parts) {
    for (std::size_t s = 0; s < patch.samples; ++s) {
        parts[s].samples = 0;
        parts[s].add(patch.triangles[s], patch.at[s]);
    }
    return patch.samples;
}

// Width of the widest lobes, in radians, whose highlights parts of a whole pixel do not hold; measured.
constexpr double kWidestSplit = 0.11;

// Returns whether a texture bends highlights of lights too finely for the parts of a whole pixel: into
// lines of a fraction of a pixel that hold most of the light.
bool splits_highlights(const Material& material) {
    const SpatialVariation* const variation = material.variation();
    return variation != nullptr && variation->normal.kind != NormalVariation::Kind::none &&
           follows_lobes(material, kWidestSplit);
}

}  // namespace

void PixelPoints::list(const PixelInput& input, std::size_t first, std::size_t last,
                       std::span<float> coverage) {
    whole.clear();
    parts.clear();
    followed = false;
    if (input.hits.offsets().size() == 1)
        list_single(input, first, last, coverage);
    else
        list_patches(input, first, last, coverage);
    for (std::vector<PixelPoint>* const list : {&whole, &parts})
        if (!std::ranges::is_sorted(*list, {}, &PixelPoint::group))
            std::ranges::stable_sort(*list, {}, &PixelPoint::group);
}

void PixelPoints::list_single(const PixelInput& input, std::size_t first, std::size_t last,
                              std::span<float> coverage) {
    const glm::vec2 at(input.hits.offsets().front());
    std::size_t range = 0;
    for (std::size_t i = first; i < last; ++i) {
        const std::optional<Hit> hit = input.hits.at(0, i);
        coverage[i - first] = hit ? 1.0F : 0.0F;
        if (!hit) continue;
        if (input.smooth != nullptr) {
            followed = followed || input.smooth->followed(hit->triangle);
            if (input.smooth->of(hit->triangle) == Smoothness::boundary) continue;
        }
        if (hit->front)
            whole.push_back({surface_point(input, hit->triangle, i, range), 1.0F, at, glm::vec2(1), false});
    }
}

void PixelPoints::list_patches(const PixelInput& input, std::size_t first, std::size_t last,
                               std::span<float> coverage) {
    const bool lit = input.local_lights != nullptr && input.local_lights->lighting().any_source();
    const std::span offsets = input.hits.offsets();
    const std::span triangles(input.geometry.triangles);
    const float weight = 1.0F / static_cast<float>(offsets.size());
    std::array<Patch, kMostPixelSamples> patches, bent;
    std::size_t range = 0;
    const Material* known = nullptr;  // material of the previous patch
    bool split = false;               // splits_highlights() of that material
    for (std::size_t i = first; i < last; ++i) {
        std::size_t count = 0;
        std::size_t covered = 0;
        for (std::size_t s = 0; s < offsets.size(); ++s) {
            const std::optional<Hit> hit = input.hits.at(s, i);
            if (!hit) continue;
            ++covered;
            if (input.smooth != nullptr) followed = followed || input.smooth->followed(hit->triangle);
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
            if (!lit) continue;
            const Material* const material = input.geometry.ranges[range].material.get();
            if (material != known) split = splits_highlights(*material);
            known = material;
            const std::size_t sides = split ? divide(patch, bent) : divide(patch, input.geometry, bent);
            whole.back().bent = sides > 1;
            for (std::size_t side = 0; sides > 1 && side < sides; ++side)
                parts.push_back(point_of(bent[side], input, i, range));
        }
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

}  // namespace nicol
