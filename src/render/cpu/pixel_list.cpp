// SPDX-License-Identifier: MIT
#include "render/cpu/pixel_list.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>

#include "render/hit_image.hpp"

namespace nicol {
namespace {

bool share_corner(const glm::uvec3& a, const glm::uvec3& b) {
    const auto in_b = [&b](std::uint32_t v) { return v == b.x || v == b.y || v == b.z; };
    return in_b(a.x) || in_b(a.y) || in_b(a.z);
}

// Samples of one smooth surface in one pixel.
struct Patch {
    std::array<std::uint32_t, kMostPixelSamples> triangles;
    std::array<glm::vec2, kMostPixelSamples> at;  // from the pixel's centre
    std::size_t samples = 0;
};

// `range`: of the patch before, which is often the same.
PixelPoint point_of(const Patch& patch, const PixelInput& input, std::size_t pixel, std::size_t& range) {
    glm::vec2 mean(0);
    for (const glm::vec2& at : std::span(patch.at).first(patch.samples)) mean += at;
    mean /= static_cast<float>(patch.samples);
    // The mean may lie between triangles; the nearest sample's then stands for all.
    std::size_t nearest = 0;
    for (std::size_t s = 1; s < patch.samples; ++s) {
        const glm::vec2 d = patch.at[s] - mean;
        const glm::vec2 least = patch.at[nearest] - mean;
        if (glm::dot(d, d) < glm::dot(least, least)) nearest = s;
    }
    const std::uint32_t triangle = patch.triangles[nearest];
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
            .pixel = static_cast<std::uint32_t>(pixel),
            .weight = static_cast<float>(patch.samples) / static_cast<float>(input.hits.offsets().size()),
            .at = mean};
}

}  // namespace

void list_points(const PixelInput& input, std::size_t first, std::size_t last, std::vector<PixelPoint>& out,
                 std::span<float> coverage) {
    out.clear();
    const std::span offsets = input.hits.offsets();
    const std::span triangles(input.geometry.triangles);
    const float weight = 1.0F / static_cast<float>(offsets.size());
    std::array<Patch, kMostPixelSamples> patches;
    std::size_t range = 0;
    for (std::size_t i = first; i < last; ++i) {
        std::size_t count = 0;
        std::size_t covered = 0;
        for (std::size_t s = 0; s < offsets.size(); ++s) {
            const std::optional<Hit> hit = input.hits.at(s, i);
            if (!hit) continue;
            ++covered;
            if (!hit->front) continue;
            const auto same = [&](const Patch& patch) {
                const std::uint32_t other = patch.triangles[patch.samples - 1];
                return other == hit->triangle || share_corner(triangles[other], triangles[hit->triangle]);
            };
            const auto known = std::span(patches).first(count);
            const auto found = std::ranges::find_if(known, same);
            Patch& patch = found != known.end() ? *found : patches[count++];
            if (found == known.end()) patch.samples = 0;
            patch.triangles[patch.samples] = hit->triangle;
            patch.at[patch.samples++] = glm::vec2(offsets[s]);
        }
        coverage[i - first] = weight * static_cast<float>(covered);
        for (const Patch& patch : std::span(patches).first(count))
            out.push_back(point_of(patch, input, i, range));
    }
    if (!std::ranges::is_sorted(out, {}, &PixelPoint::group))
        std::ranges::stable_sort(out, {}, &PixelPoint::group);
}

}  // namespace nicol
