// SPDX-License-Identifier: MIT
#include "devices/cpu/surface_shading.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "methods/high_orders.hpp"
#include "shading/channel_spans.hpp"
#include "shading/realizable_range.hpp"
#include "simd/lane_transpose.hpp"
#include "simd/work_space.hpp"
#include "specular/high_order_visibility.hpp"
#include "specular/lane_mirror.hpp"

namespace nicol {
namespace {

constexpr std::size_t kMost = PixelBatch::kMost;

constexpr std::array<std::uint8_t, kMost> kAll = [] {
    std::array<std::uint8_t, kMost> all{};
    all.fill(1);
    return all;
}();

// Numbers of sixteen vertices in a block of VisibilityBlocks.
struct alignas(32) FixedRow {
    std::array<std::int16_t, kLanes> of;
};

}  // namespace

// Work space for the points of a batch.
struct SurfaceShading::Work {
    std::array<glm::vec3, kMost> positions;
    std::array<glm::vec3, kMost> normals;
    std::array<glm::vec2, kMost> fractions;
    VertexLight light;
};

SurfaceShading::SurfaceShading(const PixelInput& input, std::span<const PointSurface> surfaces,
                               std::span<const glm::vec2> fractions)
    : input_(input), surfaces_(surfaces), fractions_(fractions) {
    if (input.local_lights != nullptr) local_lights_.emplace(input.local_lights->lighting(), input);
}

void SurfaceShading::run(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out,
                         PointCounts& counts) const {
    thread_local Work work;
    const PointSurface& surface = surfaces_[batch.points().front().range];
    const std::size_t count = batch.points().size();
    for (std::size_t begin = 0; begin < count; begin += kLanes) {
        const LaneSurface& of = batch.surfaces()[begin / kLanes];
        std::ranges::copy(of.positions, work.positions.begin() + static_cast<std::ptrdiff_t>(begin));
        std::ranges::copy(of.normals, work.normals.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    const bool harmonics = surface.textures != nullptr || surface.response != nullptr;
    const bool bounced =
        surface.bounced != nullptr && batch.points().front().occluded != 0 && batch.bounces();
    if (harmonics)
        reflect_harmonics(surface, batch, work, out);
    else
        for (const std::span<glm::vec4> channel : out) std::ranges::fill(channel, glm::vec4(0));
    if (bounced) add_bounced(*surface.bounced, batch, work, out);
    if (input_.physical && (harmonics || bounced)) {
        for (const std::span<glm::vec4> channel : out) make_physical(channel, input_.noise);
    }
    counts.shaded += count;
    if (local_lights_ && batch.reflects_lights()) add_lights(batch, out, counts);
}

void SurfaceShading::reflect_harmonics(const PointSurface& surface, const PixelBatch& batch, Work& work,
                                       std::span<const std::span<glm::vec4>> out) const {
    const std::size_t count = batch.points().size();
    find_light(surface, batch, work);

    const std::span positions = std::span(work.positions).first(count);
    const std::span normals = std::span(work.normals).first(count);
    const std::span chosen = std::span(kAll).first(count);
    HighOrderShadows shadows;
    if (!fractions_.empty()) {
        if (batch.views().shared())
            find_fractions(batch, work);
        else
            find_fractions_of_views(batch, work);
        shadows.fractions = std::span(work.fractions).first(count);
    }
    if (const TexturedSurface* const textures = surface.textures) {
        surface.shade->run(textures->responses, batch.weights(), work.light, batch.views(), positions,
                           normals, out);
        if (textures->high_orders) {
            textures->high_orders->run(batch.views(), positions, normals, batch.weights(), shadows.fractions,
                                       out);
        }
    } else {
        surface.shade->run(*surface.response, work.light, batch.views(), positions, normals, chosen, 0, count,
                           out);
        if (surface.high_orders != nullptr)
            surface.high_orders->run(batch.views(), positions, normals, chosen, shadows, 0, count, out);
    }
    if (!input_.light_factors.none()) {
        for (std::size_t c = 0; c < out.size(); ++c)
            for (glm::vec4& stokes : out[c]) stokes *= input_.light_factors.of[c];
    }
}

void SurfaceShading::add_lights(const PixelBatch& batch, std::span<const std::span<glm::vec4>> out,
                                PointCounts& counts) const {
    const Stopwatch watch;
    counts.lighting += local_lights_->add(batch, out);
    local_lights_->add_emission(batch, out);
    counts.light_seconds += 1e-3 * watch.milliseconds();
}

void SurfaceShading::find_fractions(const PixelBatch& batch, Work& work) const {
    for (std::size_t i = 0; i < batch.points().size(); ++i) {
        const glm::uvec3& corners = input_.geometry.triangles[batch.points()[i].triangle];
        const std::array<Lanes, 3>& weights = batch.surfaces()[i / kLanes].weights;
        const std::size_t lane = i % kLanes;
        work.fractions[i] = weights[0][lane] * fractions_[corners.x] +
                            weights[1][lane] * fractions_[corners.y] +
                            weights[2][lane] * fractions_[corners.z];
    }
}

void SurfaceShading::find_fractions_of_views(const PixelBatch& batch, Work& work) const {
    const WorldGeometry& geometry = input_.geometry;
    const VisibilityBlocks& visibility = *input_.high_orders->visibility();
    const MaterialPtr& material = geometry.ranges[batch.points().front().range].material;
    const HighOrderVisibility seen(visibility.order(), input_.high_orders->lobe_width(material));
    std::array<glm::vec3, kLanes> positions, normals;
    std::array<Lanes, 2> fractions;
    // A block has the coefficients of even l + m.
    const auto order = static_cast<std::size_t>(visibility.order());
    const std::span<FixedRow> block = work_space<FixedRow, FixedRow>((order + 1) * (order + 2) / 2);
    for (std::size_t begin = 0; begin < batch.points().size(); begin += kLanes) {
        const std::size_t count = std::min(kLanes, batch.points().size() - begin);
        for (std::size_t i = 0; i < count; ++i) work.fractions[begin + i] = glm::vec2(0);
        for (glm::length_t k = 0; k < 3; ++k) {
            const auto corner = [&](std::size_t i) {
                return geometry.triangles[batch.points()[begin + i].triangle][k];
            };
            for (std::size_t i = 0; i < count; ++i) {
                positions[i] = geometry.positions[corner(i)];
                normals[i] = geometry.normals[corner(i)];
            }
            const LaneMirror mirror =
                mirror_views(batch.views().subspan(begin, count), glm::dmat3(1.0),
                             std::span(positions).first(count), std::span(normals).first(count));
            // The vertices are in different lanes of different blocks, so their numbers are moved together.
            std::array<const std::int16_t*, kLanes> blocks{};
            for (std::size_t i = 0; i < count; ++i) {
                blocks[i] = visibility.block(corner(i) / kLanes);
                if (blocks[i] == nullptr) continue;
                const std::int16_t* const numbers = blocks[i] + corner(i) % kLanes;
                for (std::size_t n = 0; n < block.size(); ++n) block[n].of[i] = numbers[n * kLanes];
            }
            const bool any =
                std::ranges::any_of(blocks, [](const std::int16_t* of_lane) { return of_lane != nullptr; });
            if (any) seen.filter_block(mirror, block.front().of.data(), fractions);
            for (std::size_t i = 0; i < count; ++i) {
                const glm::vec2 of_vertex =
                    blocks[i] != nullptr ? glm::vec2(fractions[0][i], fractions[1][i]) : glm::vec2(1);
                work.fractions[begin + i] +=
                    batch.surfaces()[begin / kLanes].weights[static_cast<std::size_t>(k)][i] * of_vertex;
            }
        }
    }
}

void SurfaceShading::find_light(const PointSurface& surface, const PixelBatch& batch, Work& work) const {
    const LightLayout& layout = surface.shade->layout();
    if (surface.unoccluded != nullptr && batch.points().front().occluded == 0) {
        work.light.resize(layout, input_.light.channels(), kMost);
        surface.unoccluded->run(std::span(work.normals).first(batch.points().size()), 0,
                                batch.surfaces().size(), work.light);
        return;
    }
    interpolate(layout, *surface.light, surface.first_row, *surface.rotation, batch, work);
}

void SurfaceShading::interpolate(const LightLayout& layout, const VertexLight& rows, std::size_t first_row,
                                 const FrameRotation& rotation, const PixelBatch& batch, Work& work) const {
    const std::span points = batch.points();
    const std::span normals = std::span(work.normals).first(points.size());
    work.light.resize(layout, rows.channels(), kMost);
    for (std::size_t block = 0; block < batch.surfaces().size(); ++block) {
        std::array<std::array<const float*, kLanes>, 3> corners_of;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t point = block * kLanes + i;
            const glm::uvec3& corners =
                input_.geometry.triangles[points[point < points.size() ? point : block * kLanes].triangle];
            for (glm::length_t k = 0; k < 3; ++k)
                corners_of[static_cast<std::size_t>(k)][i] = rows.row(corners[k] - first_row);
        }
        to_lanes_weighted(corners_of, batch.surfaces()[block].weights, rows.row_size(),
                          work.light.block(block, 0).data());
        rotation.into_frames(
            normals.subspan(block * kLanes, std::min(kLanes, points.size() - block * kLanes)), work.light,
            block);
    }
}

void SurfaceShading::add_bounced(const BouncedSurface& surface, const PixelBatch& batch, Work& work,
                                 std::span<const std::span<glm::vec4>> out) const {
    thread_local std::vector<glm::vec4> reflected;
    const std::size_t count = batch.points().size();
    const std::span positions = std::span(work.positions).first(count);
    const std::span normals = std::span(work.normals).first(count);
    interpolate(surface.shade->layout(), *surface.light, 0, *surface.rotation, batch, work);
    const std::vector<std::span<glm::vec4>> channels = channel_spans(reflected, out.size(), count);
    if (batch.weights().empty())
        surface.shade->run(*surface.responses.front(), work.light, batch.views(), positions, normals,
                           std::span(kAll).first(count), 0, count, channels);
    else
        surface.shade->run(surface.responses, batch.weights(), work.light, batch.views(), positions, normals,
                           channels);
    for (std::size_t c = 0; c < out.size(); ++c)
        for (std::size_t i = 0; i < count; ++i) out[c][i] += channels[c][i];
}

}  // namespace nicol
