// SPDX-License-Identifier: MIT
#include "devices/cpu/cpu_executor.hpp"

#include <tbb/combinable.h>

#include <algorithm>
#include <atomic>
#include <deque>

#include "devices/cpu/vertex_image.hpp"
#include "devices/light_for_pixels.hpp"
#include "devices/vertex_lights.hpp"
#include "draw/pixel_image.hpp"
#include "draw/vertex_buffers.hpp"
#include "draw/visibility_buffer.hpp"
#include "material/sampled_terms.hpp"
#include "material/spatial_variation.hpp"
#include "methods/dense_method.hpp"
#include "methods/factored_method.hpp"
#include "methods/high_orders.hpp"
#include "shading/realizable_range.hpp"
#include "shading/shade.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {
namespace {

// Calls body(begin, end) for the longest runs of first <= i < last with stale(i).
template <class Stale, class Body>
void for_runs(std::size_t first, std::size_t last, const Stale& stale, const Body& body) {
    for (std::size_t i = first; i < last;) {
        if (!stale(i)) {
            ++i;
            continue;
        }
        const std::size_t begin = i;
        while (i < last && stale(i)) ++i;
        body(begin, i);
    }
}

TexturedSurface textured_surface(const SpatialVariation& variation, const FactoredMethod::Tables& tables,
                                 const PixelInput& input) {
    TexturedSurface out;
    std::vector<HighOrderLayers::Layer> high_orders;
    for (const MaterialLayer& layer : variation.layers) {
        out.responses.push_back(&tables.at(layer.material));
        if (input.high_orders == nullptr) continue;
        const HighOrderTransfer::Part& part = input.high_orders->parts()->at(layer.material);
        high_orders.push_back({.factors = &part.factors, .maps = part.maps});
    }
    if (!high_orders.empty()) out.high_orders.emplace(high_orders, input.light_to_geometry);
    return out;
}

}  // namespace

const Device kCpuDevice{
    .executor = Executor::cpu,
    .name = "threads",
    .obstacle = [](const gl::Context& /*context*/) { return std::string(); },
    .preferred = [](const gl::Context& /*context*/) { return true; },
    .make = [](const std::shared_ptr<gl::Context>& /*context*/, VertexBuffers& /*buffers*/)
        -> std::unique_ptr<RenderExecutor> { return std::make_unique<CpuExecutor>(); },
};

std::uint64_t CpuExecutor::relight(const FactoredMethod& method, const TransferInput& input,
                                   std::span<const std::uint8_t> current, RenderRun& run) {
    const std::size_t vertices = input.geometry.positions.size();
    VertexLight& light = this->light(input.at_pixels);
    light.resize(input.layout, input.light.channels(), vertices);
    const std::span normals(input.geometry.normals);
    const Relight rotation(input.layout, input.light);
    const std::optional<VisibilityProduct>& shadows = *method.shadows();
    const Bounces* const bounces = input.bounces > 0 && !input.bounces_apart ? &method.bounces() : nullptr;
    std::optional<FrameRotation> back;
    if (input.at_pixels) back.emplace(input.layout);
    const auto stale = [&](std::size_t block) {
        const auto vertices_of = current.subspan(block * kLanes);
        return std::ranges::any_of(vertices_of.first(std::min(kLanes, vertices_of.size())),
                                   [](std::uint8_t one) { return one == 0; });
    };
    std::atomic<std::uint64_t> relit = 0;
    run.workers.for_blocks(light.blocks(), "relight", run.progress, [&](std::size_t first, std::size_t last) {
        for_runs(first, last, stale, [&](std::size_t begin, std::size_t end) {
            rotation.run(normals, begin, end, light);
            if (shadows) shadows->run(light, begin, end);
            if (back)
                leave_for_pixels(*back, bounces, normals, begin, end, light);
            else if (bounces != nullptr)
                bounces->add_to(light, begin, end);
            relit += std::min(end * kLanes, vertices) - begin * kLanes;
        });
    });
    return relit;
}

bool CpuExecutor::renumber(std::span<const std::uint32_t> former, bool at_pixels, RenderRun& run) {
    run.workers.run([&] { light(at_pixels).renumber(former, at_pixels); });
    return true;
}

std::uint64_t CpuExecutor::relight(const DenseMethod& method, const TransferInput& input,
                                   std::span<const std::uint8_t> current, RenderRun& run) {
    const std::vector<DenseMethod::Run>& runs = *method.runs();
    outgoing_.resize(runs.size());
    std::atomic<std::uint64_t> relit = 0;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        const DenseTransfer& matrices = runs[i].matrices;
        VertexLight& light = outgoing_[i];
        const std::size_t count = matrices.vertices();
        const int channels = std::max(input.light.channels(), matrices.material().channels());
        light.resize(matrices.material().outgoing(), channels, count);
        // leave_for_pixels() converts the light of all vertices, so all of it must be computed anew.
        const auto stale = [&](std::size_t v) { return input.at_pixels || current[runs[i].first + v] == 0; };
        run.workers.for_vertices(0, count, count, "relight", run.progress,
                                 [&](std::size_t first, std::size_t last) {
                                     for_runs(first, last, stale, [&](std::size_t begin, std::size_t end) {
                                         matrices.apply(input.light, begin, end, 0, light);
                                         relit += end - begin;
                                     });
                                 });
        if (input.at_pixels) {
            const FrameRotation back(matrices.material().outgoing());
            const std::span normals = std::span(input.geometry.normals).subspan(runs[i].first, count);
            run.workers.for_blocks(light.blocks(), "relight", run.progress,
                                   [&](std::size_t first, std::size_t last) {
                                       leave_for_pixels(back, nullptr, normals, first, last, light);
                                   });
        }
    }
    return relit;
}

void CpuExecutor::resize(const ShadeInput& input) {
    stokes_.resize(static_cast<std::size_t>(input.channels));
    for (auto& channel : stokes_) channel.resize(input.geometry.positions.size());
}

void CpuExecutor::shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) {
    resize(input);
    const WorldGeometry& geometry = input.geometry;
    const Shade shade(input.layout, input.least_components, input.most_components);
    const std::vector<std::span<glm::vec4>> channels(stokes_.begin(), stokes_.end());
    for (const VertexRange& range : geometry.ranges) {
        const ResponseTable& table = method.tables()->at(range.material);
        run.workers.for_vertices(range.first, range.last, geometry.positions.size(), "shade", run.progress,
                                 [&](std::size_t begin, std::size_t end) {
                                     shade.run(table, light_, input.view, geometry.positions,
                                               geometry.normals, input.chosen, begin, end, channels);
                                 });
    }
}

void CpuExecutor::shade(const DenseMethod& method, const ShadeInput& input, RenderRun& run) {
    resize(input);
    for (std::size_t i = 0; i < method.runs()->size(); ++i) {
        const DenseMethod::Run& of = (*method.runs())[i];
        const std::size_t count = of.matrices.vertices();
        const std::span positions = std::span(input.geometry.positions).subspan(of.first, count);
        const std::span normals = std::span(input.geometry.normals).subspan(of.first, count);
        const Shade shade(of.matrices.material().outgoing());
        std::vector<std::span<glm::vec4>> channels;
        for (auto& channel : stokes_) channels.push_back(std::span(channel).subspan(of.first, count));
        run.workers.for_vertices(0, count, count, "shade", run.progress,
                                 [&](std::size_t begin, std::size_t end) {
                                     shade.run(*of.response, outgoing_[i], input.view, positions, normals,
                                               input.chosen.subspan(of.first, count), begin, end, channels);
                                 });
    }
}

void CpuExecutor::shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) {
    const Shade shade(input.layout, input.least_components, input.most_components);
    const FrameRotation rotation(input.layout);
    const Relight unoccluded(input.layout, input.light);
    std::vector<PointSurface> surfaces;
    // Deques, because pointers to their elements must stay valid.
    std::deque<TexturedSurface> textured;
    std::deque<BouncedSurface> bounced;
    std::optional<Shade> shade_bounced;
    std::optional<FrameRotation> rotate_bounced;
    if (input.bounces_apart) {
        const LightLayout& layout = input.bounced->layout();
        shade_bounced.emplace(layout, input.least_components, input.most_components);
        rotate_bounced.emplace(layout);
    }
    for (const VertexRange& range : input.geometry.ranges) {
        PointSurface& surface = surfaces.emplace_back(PointSurface{.shade = &shade,
                                                                   .textures = nullptr,
                                                                   .response = nullptr,
                                                                   .high_orders = nullptr,
                                                                   .light = &light_of_pixels_,
                                                                   .first_row = 0,
                                                                   .rotation = &rotation,
                                                                   .unoccluded = &unoccluded,
                                                                   .bounced = nullptr});
        const bool followed = input.follows(*range.material);
        const ResponseTables::Choice apart = FactoredMethod::apart_terms(input.sampled, followed);
        if (rotate_bounced && any_term(*range.material, [&](const Material& layer, int term) {
                return apart.has(layer, term);
            })) {
            surface.bounced = &bounced.emplace_back(BouncedSurface{.shade = &*shade_bounced,
                                                                   .light = &input.bounced->rows(),
                                                                   .rotation = &*rotate_bounced,
                                                                   .responses = {}});
            for (const MaterialPtr& layer : plain_materials(range.material))
                bounced.back().responses.push_back(&method.apart(followed).at(layer));
        }
        const SpatialVariation* const variation = range.material->variation();
        if (variation == nullptr) {
            const bool in_harmonics = any_term(*range.material, [&](const Material& layer, int term) {
                return !is_sampled(layer, term, input.sampled);
            });
            if (in_harmonics) surface.response = &method.tables()->at(range.material);
            continue;
        }
        surface.textures = &textured.emplace_back(textured_surface(*variation, *method.tables(), input));
    }
    run_pixels(input, surfaces, run);
}

void CpuExecutor::shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) {
    const std::vector<DenseMethod::Run>& runs = *method.runs();
    std::vector<Shade> shades;
    std::vector<FrameRotation> rotations;
    for (const DenseMethod::Run& of : runs) {
        shades.emplace_back(of.matrices.material().outgoing());
        rotations.emplace_back(of.matrices.material().outgoing());
    }
    std::vector<PointSurface> surfaces;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        surfaces.push_back({.shade = &shades[i],
                            .textures = nullptr,
                            .response = runs[i].response.get(),
                            .high_orders = nullptr,
                            .light = &outgoing_[i],
                            .first_row = runs[i].first,
                            .rotation = &rotations[i],
                            .unoccluded = nullptr,
                            .bounced = nullptr});
    }
    run_pixels(input, surfaces, run);
}

template <class Run>
void CpuExecutor::make_image(const PixelInput& input, const char* verb, RenderRun& run, const Run& make) {
    const int width = input.hits.width(), height = input.hits.height();
    if (image_.width != width || image_.height != height || image_.channels != input.channels)
        image_ = StokesImage(width, height, input.channels);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    std::vector<std::span<glm::vec4>> channels;
    channels.reserve(static_cast<std::size_t>(input.channels));
    for (int c = 0; c < input.channels; ++c)
        channels.emplace_back(reinterpret_cast<glm::vec4*>(image_.at(c, 0, 0).data()), pixels);
    run.workers.for_vertices(0, pixels, pixels, verb, run.progress,
                             [&](std::size_t begin, std::size_t end) { make(begin, end, channels); });
}

void CpuExecutor::interpolate(const PixelInput& input, RenderRun& run) {
    const VertexImage image(input, stokes_, run);
    make_image(input, "draw", run, [&](std::size_t begin, std::size_t end, const auto& channels) {
        image.run(begin, end, channels);
    });
}

void CpuExecutor::run_pixels(const PixelInput& input, std::span<PointSurface> surfaces, RenderRun& run) {
    std::vector<HighOrder> high_orders;
    if (input.high_orders != nullptr) {
        compute_fractions(*input.high_orders, input, run);
        high_orders.reserve(surfaces.size());
        for (std::size_t i = 0; i < surfaces.size(); ++i) {
            if (surfaces[i].textures != nullptr || surfaces[i].response == nullptr) continue;
            const HighOrderTransfer::Part& part =
                input.high_orders->parts()->at(input.geometry.ranges[i].material);
            surfaces[i].high_orders =
                &high_orders.emplace_back(part.factors, part.maps, input.light_to_geometry);
        }
    }
    const bool fractions = input.high_orders != nullptr && !input.high_orders->visibility()->empty();
    const SurfaceShading of_points(input, surfaces, fractions ? fractions_ : std::span<const glm::vec2>());
    const PixelShading shading(input, of_points);
    std::atomic<std::uint64_t> shaded = 0, rays = 0;
    tbb::combinable<LightingTally> tallies, followed;
    tbb::combinable<SurfaceTally> surfaces_shown;
    std::atomic<double> light_seconds = 0;
    make_image(input, "shade", run, [&](std::size_t begin, std::size_t end, const auto& channels) {
        const PointCounts counts = shading.run(begin, end, channels);
        shaded += counts.shaded;
        tallies.local() += counts.lighting;
        followed.local() += counts.followed;
        surfaces_shown.local() += counts.surfaces;
        light_seconds += counts.light_seconds;
        rays += counts.ray_count;
    });
    run.statistics.pixels_shaded += shaded;
    run.statistics.smooth_rays += rays;
    tallies.combine_each([&](const LightingTally& tally) { run.add(tally); });
    followed.combine_each([&](const LightingTally& tally) { run.followed += tally; });
    surfaces_shown.combine_each([&](const SurfaceTally& tally) { run.surfaces += tally; });
    run.statistics.light_ms += 1e3 * light_seconds / run.workers.count();
}

void CpuExecutor::compute_fractions(const HighOrderTransfer& high_orders, const ShadeInput& input,
                                    RenderRun& run) {
    const WorldGeometry& geometry = input.geometry;
    const std::size_t vertices = geometry.positions.size();
    const VisibilityBlocks& visibility = *high_orders.visibility();
    fractions_.resize(visibility.empty() ? 0 : vertices);
    if (visibility.empty()) return;
    for (const VertexRange& range : geometry.ranges) {
        const HighOrderVisibility seen(visibility.order(), high_orders.lobe_width(range.material));
        run.workers.for_vertices(range.first, range.last, vertices, "shade", run.progress,
                                 [&](std::size_t begin, std::size_t end) {
                                     seen.run(input.view, geometry.positions, geometry.normals, input.chosen,
                                              visibility, begin, end, fractions_);
                                 });
    }
}

void CpuExecutor::specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& run) {
    const WorldGeometry& geometry = input.geometry;
    const VisibilityBlocks& visibility = *high_orders.visibility();
    const std::vector<std::span<glm::vec4>> channels(stokes_.begin(), stokes_.end());
    for (const VertexRange& range : geometry.ranges) {
        const HighOrderTransfer::Part& part = high_orders.parts()->at(range.material);
        const HighOrder high(part.factors, part.maps, input.light_to_geometry);
        const HighOrderVisibility seen(visibility.order(), high_orders.lobe_width(range.material));
        const HighOrderShadows shadows{
            .fractions = {}, .visibility = visibility.empty() ? nullptr : &seen, .seen = &visibility};
        run.workers.for_vertices(range.first, range.last, geometry.positions.size(), "shade", run.progress,
                                 [&](std::size_t begin, std::size_t end) {
                                     high.run(input.view, geometry.positions, geometry.normals, input.chosen,
                                              shadows, begin, end, channels);
                                 });
    }
}

void CpuExecutor::scale(const ShadeInput& input) {
    for (std::size_t c = 0; c < stokes_.size(); ++c) {
        for (std::size_t v = 0; v < stokes_[c].size(); ++v)
            if (input.chosen[v] != 0) stokes_[c][v] *= input.light_factors.of[c];
    }
}

void CpuExecutor::make_physical(const ShadeInput& input) {
    for (auto& channel : stokes_) {
        for (std::size_t v = 0; v < channel.size(); ++v)
            if (input.chosen[v] != 0)
                moved_ += nicol::make_physical(std::span(channel).subspan(v, 1), input.noise);
    }
}

void CpuExecutor::illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) {
    const std::vector<std::span<glm::vec4>> channels(stokes_.begin(), stokes_.end());
    VertexLights(lights, input).add(run, channels);
}

void CpuExecutor::store(VertexBuffers& buffers) const {
    buffers.upload(stokes_);
}

void CpuExecutor::store(PixelImage& image) const {
    for (int c = 0; c < image.channels(); ++c) {
        const std::size_t numbers = image_.data.size() / static_cast<std::size_t>(image_.channels);
        image.channel(c).update(
            std::span(image_.data).subspan(static_cast<std::size_t>(c) * numbers, numbers));
    }
}

void CpuExecutor::count(Statistics& statistics) const {
    for (const VertexLight& light : outgoing_) statistics.transfer_bytes += light.bytes();
    for (const auto& channel : stokes_) statistics.transfer_bytes += channel.size() * sizeof(glm::vec4);
    statistics.transfer_bytes += image_.data.size() * sizeof(float) + light_.bytes() +
                                 light_of_pixels_.bytes() + fractions_.size() * sizeof(glm::vec2);
}

}  // namespace nicol
