// SPDX-License-Identifier: MIT
#include "render/cpu/pixel_shading.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <tuple>

#include "render/cpu/textured_pixels.hpp"
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

bool share_corner(const glm::uvec3& a, const glm::uvec3& b) {
    const auto in_b = [&b](std::uint32_t v) { return v == b.x || v == b.y || v == b.z; };
    return in_b(a.x) || in_b(a.y) || in_b(a.z);
}

}  // namespace

struct PixelShading::Batch {
    std::array<LaneSurface, kBatch / kLanes> surfaces;
    std::array<LaneSurface, kBatch / kLanes> given;  // of a material that varies, before they are sorted
    std::array<glm::vec3, kBatch> positions;
    std::array<glm::vec3, kBatch> normals;
    std::array<glm::vec2, kBatch> fractions;
    VertexLight light;
    std::vector<glm::vec4> stokes;
    // Where the material varies.
    TexturedPixels textures;
    std::vector<Pixel> sorted;
    // Of the pixels, in the order in which they are shaded.
    std::vector<std::uint32_t> triangles, indices;
};

// Samples of one smooth surface in one pixel.
struct PixelShading::Patch {
    std::array<std::uint32_t, kMostPixelSamples> triangles;
    std::array<glm::vec2, kMostPixelSamples> at;  // from the pixel's centre
    std::size_t samples = 0;
};

PixelShading::PixelShading(const PixelInput& input, std::span<const PixelSurface> surfaces,
                           std::span<const glm::vec2> fractions)
    : input_(input), surfaces_(surfaces), fractions_(fractions) {
    if (input.small_lights != nullptr) small_lights_.emplace(*input.small_lights, input);
}

void PixelShading::collect(std::size_t first, std::size_t last, std::vector<Pixel>& out,
                           std::span<float> coverage) const {
    out.clear();
    const std::span offsets = input_.hits.offsets();
    const std::span triangles(input_.geometry.triangles);
    const float weight = 1.0F / static_cast<float>(offsets.size());
    std::array<Patch, kMostPixelSamples> patches;
    std::size_t surface = 0;
    for (std::size_t i = first; i < last; ++i) {
        std::size_t count = 0;
        std::size_t covered = 0;
        for (std::size_t s = 0; s < offsets.size(); ++s) {
            const std::optional<Hit> hit = input_.hits.at(s, i);
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
        for (const Patch& patch : std::span(patches).first(count)) add(patch, i, surface, out);
    }
    if (!std::ranges::is_sorted(out, {}, &Pixel::group)) std::ranges::stable_sort(out, {}, &Pixel::group);
}

// `surface`: of the patch before, which is often the same.
void PixelShading::add(const Patch& patch, std::size_t index, std::size_t& surface,
                       std::vector<Pixel>& out) const {
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
    const glm::uvec3& corners = input_.geometry.triangles[triangle];
    if (corners.x < surfaces_[surface].first || corners.x >= surfaces_[surface].last) {
        const auto found = std::ranges::upper_bound(surfaces_, corners.x, {}, &PixelSurface::last);
        surface = static_cast<std::size_t>(found - surfaces_.begin());
    }
    const bool occluded = input_.visibility != nullptr && !(input_.visibility->unoccluded(corners.x) &&
                                                            input_.visibility->unoccluded(corners.y) &&
                                                            input_.visibility->unoccluded(corners.z));
    out.push_back(
        {.surface = static_cast<std::uint32_t>(surface),
         .occluded = occluded ? 1U : 0U,
         .triangle = triangle,
         .index = static_cast<std::uint32_t>(index),
         .weight = static_cast<float>(patch.samples) / static_cast<float>(input_.hits.offsets().size()),
         .at = mean});
}

PixelCounts PixelShading::run(std::size_t first, std::size_t last,
                              std::span<const std::span<glm::vec4>> out) const {
    // Backs of surfaces are black.
    for (const std::span<glm::vec4> channel : out)
        std::ranges::fill(channel.subspan(first, last - first), glm::vec4(0));
    thread_local std::vector<Pixel> pixels;
    thread_local std::vector<float> coverage;
    thread_local Batch batch;
    coverage.resize(last - first);
    collect(first, last, pixels, coverage);
    PixelCounts counts{.shaded = pixels.size()};
    for (std::size_t begin = 0; begin < pixels.size();) {
        std::size_t end = begin;
        while (end < pixels.size() && end - begin < kBatch && pixels[end].group() == pixels[begin].group())
            ++end;
        shade(std::span(pixels).subspan(begin, end - begin), batch, out, counts);
        begin = end;
    }
    if (input_.background != nullptr) {
        input_.background->add(rays(), static_cast<float>(input_.light_scale), input_.most_components, first,
                               last, coverage, out);
    }
    return counts;
}

void PixelShading::shade(std::span<const Pixel> given, Batch& batch,
                         std::span<const std::span<glm::vec4>> out, PixelCounts& counts) const {
    const PixelSurface& surface = surfaces_[given.front().surface];
    find_points(given, batch);
    const TexturedSurface* const textures = surface.textures;
    const std::span pixels = textures != nullptr ? find_textures(*textures, given, batch) : given;
    const std::size_t count = pixels.size();
    for (std::size_t begin = 0; begin < count; begin += kLanes) {
        const LaneSurface& of = batch.surfaces[begin / kLanes];
        std::ranges::copy(of.positions, batch.positions.begin() + static_cast<std::ptrdiff_t>(begin));
        std::ranges::copy(of.normals, batch.normals.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    find_light(surface, pixels, batch);

    batch.stokes.resize(out.size() * kBatch);
    std::vector<std::span<glm::vec4>> stokes;
    for (std::size_t c = 0; c < out.size(); ++c)
        stokes.push_back(std::span(batch.stokes).subspan(c * kBatch, count));
    const std::span positions = std::span(batch.positions).first(count);
    const std::span normals = std::span(batch.normals).first(count);
    const std::span chosen = std::span(kAll).first(count);
    HighOrderShadows shadows;
    if (!fractions_.empty()) {
        find_fractions(pixels, batch);
        shadows.fractions = std::span(batch.fractions).first(count);
    }
    if (textures != nullptr) {
        const std::span weights = batch.textures.weights();
        surface.shade->run(textures->responses, weights, batch.light, input_.view, positions, normals,
                           stokes);
        if (textures->high_orders) {
            textures->high_orders->run(input_.view, positions, normals, weights, shadows.fractions, stokes);
        }
    } else {
        surface.shade->run(*surface.response, batch.light, input_.view, positions, normals, chosen, 0, count,
                           stokes);
        if (surface.high_orders != nullptr)
            surface.high_orders->run(input_.view, positions, normals, chosen, shadows, 0, count, stokes);
    }
    if (input_.physical) {
        for (const std::span<glm::vec4> channel : stokes) make_physical(channel, input_.noise);
    }
    if (small_lights_) add_small_lights(pixels, batch, stokes, counts);
    glm::vec4 wanted(0);
    for (std::size_t p = 0; p < input_.most_components; ++p) wanted[static_cast<glm::length_t>(p)] = 1;
    for (std::size_t c = 0; c < out.size(); ++c) {
        for (std::size_t i = 0; i < count; ++i)
            out[c][pixels[i].index] += pixels[i].weight * wanted * stokes[c][i];
    }
}

void PixelShading::add_small_lights(std::span<const Pixel> pixels, Batch& batch,
                                    std::span<const std::span<glm::vec4>> stokes, PixelCounts& counts) const {
    const Stopwatch watch;
    batch.triangles.clear();
    batch.indices.clear();
    for (const Pixel& pixel : pixels) {
        batch.triangles.push_back(pixel.triangle);
        batch.indices.push_back(pixel.index);
    }
    const Pixel& any = pixels.front();
    const bool textured = surfaces_[any.surface].textures != nullptr;
    counts.rays +=
        small_lights_->add(input_.geometry.ranges[any.surface],
                           {.surfaces = batch.surfaces,
                            .triangles = batch.triangles,
                            .pixels = batch.indices,
                            .weights = textured ? batch.textures.weights() : std::span<const LayerWeights>(),
                            .shadowed = input_.visibility == nullptr || any.occluded != 0},
                           stokes);
    counts.light_seconds += 1e-3 * watch.milliseconds();
}

std::span<const PixelShading::Pixel> PixelShading::find_textures(const TexturedSurface& surface,
                                                                 std::span<const Pixel> pixels,
                                                                 Batch& batch) const {
    batch.triangles.clear();
    for (const Pixel& pixel : pixels) batch.triangles.push_back(pixel.triangle);
    const std::size_t blocks = (pixels.size() + kLanes - 1) / kLanes;
    batch.textures.find(*surface.variation, surface.back,
                        {.geometry = input_.geometry,
                         .projection = input_.projection,
                         .width = input_.hits.width(),
                         .height = input_.hits.height()},
                        batch.triangles, std::span(batch.surfaces).first(blocks));
    const std::span order = batch.textures.order();
    if (order.empty()) return pixels;
    batch.given = batch.surfaces;
    batch.sorted.clear();
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const std::uint32_t from = order[i];
        batch.sorted.push_back(pixels[from]);
        const LaneSurface& given = batch.given[from / kLanes];
        LaneSurface& sorted = batch.surfaces[i / kLanes];
        for (std::size_t k = 0; k < 3; ++k) sorted.weights[k][i % kLanes] = given.weights[k][from % kLanes];
        sorted.positions[i % kLanes] = given.positions[from % kLanes];
        sorted.normals[i % kLanes] = given.normals[from % kLanes];
    }
    return batch.sorted;
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
                                         static_cast<double>(column) + 0.5 + static_cast<double>(pixel.at.x),
                                         static_cast<double>(row) + 0.5 + static_cast<double>(pixel.at.y)));
        }
        LaneSurface& found = batch.surfaces[begin / kLanes];
        find_surface(input_.view, geometry.positions, geometry.normals, std::span(triangles).first(count),
                     std::span(at).first(count), found);
    }
}

PixelRays PixelShading::rays() const {
    const Projection& projection = input_.projection;
    const Viewpoint& view = projection.view;
    const glm::dmat3 to_light = glm::transpose(input_.light_to_geometry);
    const auto through = [&](double x, double y) {
        if (view.orthographic) return to_light * view.forward;
        const glm::dvec2 at =
            on_image_plane(projection, input_.hits.width(), input_.hits.height(), x + 0.5, y + 0.5);
        return to_light * (view.forward + at.x * view.right + at.y * view.up);
    };
    const glm::dvec3 first = through(0, 0);
    return {.first = first,
            .right = through(1, 0) - first,
            .down = through(0, 1) - first,
            .up = to_light * view.up,
            .width = static_cast<std::size_t>(input_.hits.width())};
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
