// SPDX-License-Identifier: MIT
#include "render/cpu/pixel_shading.hpp"

#include <algorithm>
#include <array>
#include <tuple>

#include "render/hit_image.hpp"
#include "shading/lane_surface.hpp"
#include "shading/physical_range.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/work_space.hpp"

namespace nicol {
namespace {

// Pixels that are shaded together, so that what every call costs counts for many.
constexpr std::size_t kBatch = 16 * kLanes;

constexpr std::array<std::uint8_t, kBatch> kAll = [] {
    std::array<std::uint8_t, kBatch> all{};
    all.fill(1);
    return all;
}();

}  // namespace

struct PixelShading::Batch {
    std::array<LaneSurface, kBatch / kLanes> surfaces;
    std::array<glm::vec3, kBatch> positions;
    std::array<glm::vec3, kBatch> normals;
    std::array<glm::vec2, kBatch> fractions;
    VertexLight light;
    std::vector<glm::vec4> stokes;
};

PixelShading::PixelShading(const PixelInput& input, std::span<const PixelSurface> surfaces,
                           std::span<const glm::vec2> fractions, std::span<const glm::vec4> hits)
    : input_(input), surfaces_(surfaces), fractions_(fractions), hits_(hits) {}

void PixelShading::collect(std::size_t first, std::size_t last, std::vector<Pixel>& out) const {
    out.clear();
    const WorldGeometry& geometry = input_.geometry;
    std::size_t surface = 0;
    for (std::size_t i = first; i < last; ++i) {
        const std::optional<Hit> hit = HitImage::of(hits_[i]);
        if (!hit || !hit->front) continue;
        const glm::uvec3& corners = geometry.triangles[hit->triangle];
        if (corners.x < surfaces_[surface].first || corners.x >= surfaces_[surface].last) {
            const auto found = std::ranges::upper_bound(surfaces_, corners.x, {}, &PixelSurface::last);
            surface = static_cast<std::size_t>(found - surfaces_.begin());
        }
        const bool occluded = input_.visibility != nullptr && !(input_.visibility->unoccluded(corners.x) &&
                                                                input_.visibility->unoccluded(corners.y) &&
                                                                input_.visibility->unoccluded(corners.z));
        out.push_back({.surface = static_cast<std::uint32_t>(surface),
                       .occluded = occluded ? 1U : 0U,
                       .triangle = hit->triangle,
                       .index = static_cast<std::uint32_t>(i)});
    }
    if (!std::ranges::is_sorted(out, {}, &Pixel::group)) std::ranges::stable_sort(out, {}, &Pixel::group);
}

std::size_t PixelShading::run(std::size_t first, std::size_t last,
                              std::span<const std::span<glm::vec4>> out) const {
    // Backs of surfaces are black.
    for (const std::span<glm::vec4> channel : out)
        std::ranges::fill(channel.subspan(first, last - first), glm::vec4(0));
    thread_local std::vector<Pixel> pixels;
    thread_local Batch batch;
    collect(first, last, pixels);
    for (std::size_t begin = 0; begin < pixels.size();) {
        std::size_t end = begin;
        while (end < pixels.size() && end - begin < kBatch && pixels[end].group() == pixels[begin].group())
            ++end;
        shade(std::span(pixels).subspan(begin, end - begin), batch, out);
        begin = end;
    }
    return pixels.size();
}

void PixelShading::shade(std::span<const Pixel> pixels, Batch& batch,
                         std::span<const std::span<glm::vec4>> out) const {
    const PixelSurface& surface = surfaces_[pixels.front().surface];
    const std::size_t count = pixels.size();
    find_points(pixels, batch);
    find_light(surface, pixels, batch);

    batch.stokes.resize(out.size() * kBatch);
    std::vector<std::span<glm::vec4>> stokes;
    for (std::size_t c = 0; c < out.size(); ++c)
        stokes.push_back(std::span(batch.stokes).subspan(c * kBatch, count));
    const std::span positions = std::span(batch.positions).first(count);
    const std::span normals = std::span(batch.normals).first(count);
    const std::span chosen = std::span(kAll).first(count);
    surface.shade->run(*surface.response, batch.light, input_.view, positions, normals, chosen, 0, count,
                       stokes);
    if (surface.high_orders != nullptr) {
        HighOrderShadows shadows;
        if (!fractions_.empty()) {
            find_fractions(pixels, batch);
            shadows.fractions = std::span(batch.fractions).first(count);
        }
        surface.high_orders->run(input_.view, positions, normals, chosen, shadows, 0, count, stokes);
    }
    for (std::size_t c = 0; c < out.size(); ++c) {
        if (input_.physical) make_physical(stokes[c]);
        for (std::size_t i = 0; i < count; ++i) out[c][pixels[i].index] = stokes[c][i];
    }
}

void PixelShading::find_points(std::span<const Pixel> pixels, Batch& batch) const {
    const WorldGeometry& geometry = input_.geometry;
    const auto width = static_cast<std::size_t>(input_.hits.width());
    for (std::size_t begin = 0; begin < pixels.size(); begin += kLanes) {
        const std::size_t count = std::min(kLanes, pixels.size() - begin);
        std::array<Corners, kLanes> triangles;
        std::array<glm::vec2, kLanes> at;
        for (std::size_t i = 0; i < count; ++i) {
            const Pixel& pixel = pixels[begin + i];
            triangles[i] = geometry.triangles[pixel.triangle];
            const std::size_t column = pixel.index % width;
            const std::size_t row = pixel.index / width;
            at[i] =
                glm::vec2(on_image_plane(input_.projection, input_.hits.width(), input_.hits.height(),
                                         static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5));
        }
        LaneSurface& found = batch.surfaces[begin / kLanes];
        find_surface(input_.view, geometry.positions, geometry.normals, std::span(triangles).first(count),
                     std::span(at).first(count), found);
        std::ranges::copy(found.positions, batch.positions.begin() + static_cast<std::ptrdiff_t>(begin));
        std::ranges::copy(found.normals, batch.normals.begin() + static_cast<std::ptrdiff_t>(begin));
    }
}

void PixelShading::find_fractions(std::span<const Pixel> pixels, Batch& batch) const {
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const glm::uvec3& corners = input_.geometry.triangles[pixels[i].triangle];
        const std::array<Lanes, 3>& weights = batch.surfaces[i / kLanes].weights;
        const std::size_t lane = i % kLanes;
        batch.fractions[i] = weights[0][lane] * fractions_[corners.x] +
                             weights[1][lane] * fractions_[corners.y] +
                             weights[2][lane] * fractions_[corners.z];
    }
}

void PixelShading::find_light(const PixelSurface& surface, std::span<const Pixel> pixels,
                              Batch& batch) const {
    const LightLayout& layout = surface.shade->layout();
    const std::span normals = std::span(batch.normals).first(pixels.size());
    const std::size_t blocks = (pixels.size() + kLanes - 1) / kLanes;
    if (surface.unoccluded != nullptr && pixels.front().occluded == 0) {
        batch.light.resize(layout, input_.light.channels(), kBatch);
        surface.unoccluded->run(normals, 0, blocks, batch.light);
        return;
    }
    const VertexLight& from = *surface.light;
    batch.light.resize(layout, from.channels(), kBatch);
    for (std::size_t block = 0; block < blocks; ++block) {
        std::array<std::array<const float*, kLanes>, 3> rows;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t pixel = block * kLanes + i;
            const glm::uvec3& corners =
                input_.geometry.triangles[pixels[pixel < pixels.size() ? pixel : block * kLanes].triangle];
            for (glm::length_t k = 0; k < 3; ++k)
                rows[static_cast<std::size_t>(k)][i] = from.row(corners[k] - surface.first_row);
        }
        to_lanes_weighted(rows, batch.surfaces[block].weights, from.row_size(),
                          batch.light.block(block, 0).data());
        surface.rotation->into_frames(
            normals.subspan(block * kLanes, std::min(kLanes, pixels.size() - block * kLanes)), batch.light,
            block);
    }
}

}  // namespace nicol
