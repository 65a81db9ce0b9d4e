// SPDX-License-Identifier: MIT
#include "devices/cpu/pixel_shading.hpp"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "devices/pixel_batch.hpp"
#include "draw/visibility_buffer.hpp"
#include "shading/realizable_range.hpp"
#include "simd/lane_transpose.hpp"

namespace nicol {
namespace {

constexpr std::size_t kMost = PixelBatch::kMost;

constexpr std::array<std::uint8_t, kMost> kAll = [] {
    std::array<std::uint8_t, kMost> all{};
    all.fill(1);
    return all;
}();

}  // namespace

// Work space for the points of a batch.
struct PixelShading::Work {
    std::array<glm::vec3, kMost> positions;
    std::array<glm::vec3, kMost> normals;
    std::array<glm::vec2, kMost> fractions;
    VertexLight light;
    std::vector<glm::vec4> stokes;
};

PixelShading::PixelShading(const PixelInput& input, std::span<const PixelSurface> surfaces,
                           std::span<const glm::vec2> fractions)
    : input_(input), surfaces_(surfaces), fractions_(fractions) {
    if (input.local_lights != nullptr) local_lights_.emplace(*input.local_lights, input);
}

PixelCounts PixelShading::run(std::size_t first, std::size_t last,
                              std::span<const std::span<glm::vec4>> out) const {
    // Backs of surfaces are black, so they keep this value.
    for (const std::span<glm::vec4> channel : out)
        std::ranges::fill(channel.subspan(first, last - first), glm::vec4(0));
    thread_local std::vector<PixelPoint> points;
    thread_local std::vector<float> coverage;
    thread_local PixelBatch batch;
    thread_local Work work;
    coverage.resize(last - first);
    list_points(input_, first, last, points, coverage);
    PixelCounts counts{.shaded = points.size()};
    for (std::span<const PixelPoint> rest(points); !rest.empty();
         rest = rest.subspan(batch.points().size())) {
        batch.take(input_, rest);
        shade(batch, work, out, counts);
    }
    if (input_.background != nullptr) {
        input_.background->add(rays(), static_cast<float>(input_.light_scale), input_.most_components, first,
                               last, coverage, out);
    }
    return counts;
}

void PixelShading::shade(const PixelBatch& batch, Work& work, std::span<const std::span<glm::vec4>> out,
                         PixelCounts& counts) const {
    const PixelSurface& surface = surfaces_[batch.points().front().range];
    const std::size_t count = batch.points().size();
    for (std::size_t begin = 0; begin < count; begin += kLanes) {
        const LaneSurface& of = batch.surfaces()[begin / kLanes];
        std::ranges::copy(of.positions, work.positions.begin() + static_cast<std::ptrdiff_t>(begin));
        std::ranges::copy(of.normals, work.normals.begin() + static_cast<std::ptrdiff_t>(begin));
    }
    find_light(surface, batch, work);

    work.stokes.resize(out.size() * kMost);
    std::vector<std::span<glm::vec4>> stokes;
    for (std::size_t c = 0; c < out.size(); ++c)
        stokes.push_back(std::span(work.stokes).subspan(c * kMost, count));
    const std::span positions = std::span(work.positions).first(count);
    const std::span normals = std::span(work.normals).first(count);
    const std::span chosen = std::span(kAll).first(count);
    HighOrderShadows shadows;
    if (!fractions_.empty()) {
        find_fractions(batch, work);
        shadows.fractions = std::span(work.fractions).first(count);
    }
    if (const TexturedSurface* const textures = surface.textures) {
        surface.shade->run(textures->responses, batch.weights(), work.light, input_.view, positions, normals,
                           stokes);
        if (textures->high_orders) {
            textures->high_orders->run(input_.view, positions, normals, batch.weights(), shadows.fractions,
                                       stokes);
        }
    } else {
        surface.shade->run(*surface.response, work.light, input_.view, positions, normals, chosen, 0, count,
                           stokes);
        if (surface.high_orders != nullptr)
            surface.high_orders->run(input_.view, positions, normals, chosen, shadows, 0, count, stokes);
    }
    if (input_.physical) {
        for (const std::span<glm::vec4> channel : stokes) make_physical(channel, input_.noise);
    }
    if (local_lights_) add_local_lights(batch, stokes, counts);
    batch.gather(stokes, input_.most_components, 0, out);
}

void PixelShading::add_local_lights(const PixelBatch& batch, std::span<const std::span<glm::vec4>> stokes,
                                    PixelCounts& counts) const {
    const Stopwatch watch;
    counts.lighting += local_lights_->add(batch, stokes);
    counts.light_seconds += 1e-3 * watch.milliseconds();
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

void PixelShading::find_fractions(const PixelBatch& batch, Work& work) const {
    for (std::size_t i = 0; i < batch.points().size(); ++i) {
        const glm::uvec3& corners = input_.geometry.triangles[batch.points()[i].triangle];
        const std::array<Lanes, 3>& weights = batch.surfaces()[i / kLanes].weights;
        const std::size_t lane = i % kLanes;
        work.fractions[i] = weights[0][lane] * fractions_[corners.x] +
                            weights[1][lane] * fractions_[corners.y] +
                            weights[2][lane] * fractions_[corners.z];
    }
}

void PixelShading::find_light(const PixelSurface& surface, const PixelBatch& batch, Work& work) const {
    const LightLayout& layout = surface.shade->layout();
    const std::span points = batch.points();
    const std::span normals = std::span(work.normals).first(points.size());
    const std::size_t blocks = batch.surfaces().size();
    if (surface.unoccluded != nullptr && points.front().occluded == 0) {
        work.light.resize(layout, input_.light.channels(), kMost);
        surface.unoccluded->run(normals, 0, blocks, work.light);
        return;
    }
    const VertexLight& from = *surface.light;
    work.light.resize(layout, from.channels(), kMost);
    for (std::size_t block = 0; block < blocks; ++block) {
        std::array<std::array<const float*, kLanes>, 3> rows;
        for (std::size_t i = 0; i < kLanes; ++i) {
            const std::size_t point = block * kLanes + i;
            const glm::uvec3& corners =
                input_.geometry.triangles[points[point < points.size() ? point : block * kLanes].triangle];
            for (glm::length_t k = 0; k < 3; ++k)
                rows[static_cast<std::size_t>(k)][i] = from.row(corners[k] - surface.first_row);
        }
        to_lanes_weighted(rows, batch.surfaces()[block].weights, from.row_size(),
                          work.light.block(block, 0).data());
        surface.rotation->into_frames(
            normals.subspan(block * kLanes, std::min(kLanes, points.size() - block * kLanes)), work.light,
            block);
    }
}

}  // namespace nicol
