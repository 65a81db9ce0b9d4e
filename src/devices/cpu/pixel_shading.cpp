// SPDX-License-Identifier: MIT
#include "devices/cpu/pixel_shading.hpp"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "devices/pixel_batch.hpp"
#include "draw/visibility_buffer.hpp"
#include "shading/channel_spans.hpp"

namespace nicol {

namespace {

// Returns the rays through the pixels of an image, in the distant light's axes.
PixelRays rays_through(const PixelInput& input) {
    const Projection& projection = input.projection;
    const Viewpoint& view = projection.view;
    const glm::dmat3 to_light = glm::transpose(input.light_to_geometry);
    const auto through = [&](double x, double y) {
        if (view.orthographic) return to_light * view.forward;
        const glm::dvec2 at =
            on_image_plane(projection, input.hits.width(), input.hits.height(), x + 0.5, y + 0.5);
        return to_light * (view.forward + at.x * view.right + at.y * view.up);
    };
    const glm::dvec3 first = through(0, 0);
    return {.first = first,
            .right = through(1, 0) - first,
            .down = through(0, 1) - first,
            .up = to_light * view.up,
            .width = static_cast<std::size_t>(input.hits.width())};
}

// Adds the pixels of an image from `first` on, as many as coverage, the share of surfaces in each. points: of
// these pixels.
void add_pixels(const PixelInput& input, std::size_t first, std::span<const float> coverage,
                std::span<const PixelPoint> points, std::span<const std::span<glm::vec4>> image,
                SurfaceTally& tally) {
    thread_local std::vector<float> reflecting;  // share of each pixel
    reflecting.assign(coverage.size(), 0.0F);
    for (const PixelPoint& point : points)
        if (input.geometry.ranges[point.range].emission == nullptr)
            reflecting[point.pixel - first] += point.weight;
    constexpr float whole = 0.999F;
    for (std::size_t i = 0; i < coverage.size(); ++i) {
        tally.covered += static_cast<double>(coverage[i]) * static_cast<double>(image.size());
        if (reflecting[i] < whole) continue;
        tally.whole += image.size();
        for (const std::span<glm::vec4> channel : image) {
            const auto s0 = static_cast<double>(channel[first + i].x);
            tally.power += s0 * s0;
        }
    }
}

}  // namespace

void add_background(const PixelInput& input, std::size_t first, std::size_t last,
                    std::span<const float> coverage, std::span<const std::span<glm::vec4>> out) {
    if (input.background == nullptr) return;
    input.background->add(rays_through(input), static_cast<float>(input.light_scale), input.most_components,
                          first, last, coverage, out);
}

PointCounts PixelShading::run(std::size_t first, std::size_t last,
                              std::span<const std::span<glm::vec4>> out) const {
    // Backs of surfaces are black, so they keep this value.
    for (const std::span<glm::vec4> channel : out)
        std::ranges::fill(channel.subspan(first, last - first), glm::vec4(0));
    thread_local PixelPoints points;
    thread_local std::vector<float> coverage;
    thread_local PixelBatch batch;
    thread_local std::vector<glm::vec4> light;
    coverage.resize(last - first);
    points.list(input_, first, last, coverage);
    PointCounts counts;
    const auto shade = [&](std::span<const PixelPoint> rest, const auto& run) {
        for (; !rest.empty(); rest = rest.subspan(batch.points().size())) {
            batch.take(input_, rest);
            const std::vector<std::span<glm::vec4>> stokes =
                channel_spans(light, out.size(), batch.points().size());
            run(stokes);
            batch.gather(stokes, input_.most_components, 0, out);
        }
    };
    shade(points.whole, [&](const auto& stokes) { surfaces_.run(batch, stokes, counts); });
    shade(points.parts, [&](const auto& stokes) {
        for (const std::span<glm::vec4> channel : stokes) std::ranges::fill(channel, glm::vec4(0));
        surfaces_.add_lights(batch, stokes, counts);
    });
    add_background(input_, first, last, coverage, out);
    if (chains_ && points.followed) chains_->add(first, last, out, counts);
    add_pixels(input_, first, coverage, points.whole, out, counts.surfaces);
    return counts;
}

}  // namespace nicol
