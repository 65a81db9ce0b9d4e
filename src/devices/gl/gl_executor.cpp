// SPDX-License-Identifier: MIT
#include "devices/gl/gl_executor.hpp"

#include <algorithm>
#include <utility>

#include "devices/vertex_lights.hpp"
#include "draw/visibility_buffer.hpp"
#include "gl/draw.hpp"
#include "surfaces/plain_materials.hpp"

namespace nicol {
namespace {

constexpr std::size_t kVectorsOfStep = std::size_t{1} << 20;  // Stokes vectors of one dispatch

/// Runs a program for the Stokes vectors of points first <= i < last in all channels. The program takes them
/// as binding 0 with the uniforms `first_channel`, `channel_step` and `count`.
void run_in_steps(gl::Program& program, const StokesBuffer& stokes, std::size_t first, std::size_t last) {
    program.set("channel_step", static_cast<int>(stokes.step()));
    const auto run = [&](gl::ChannelGroup channels) {
        if (program.uses("first_channel")) program.set("first_channel", channels.first);
        for (std::size_t begin = first; begin < last; begin += kVectorsOfStep) {
            const std::size_t end = std::min(begin + kVectorsOfStep, last);
            std::ignore = stokes.bind(0, channels, begin, end);
            program.set("count", static_cast<int>(end - begin));
            gl::dispatch(program, gl::groups_for(end - begin), 1, static_cast<unsigned>(channels.count));
        }
    };
    gl::for_independent_channels(*program.context(), stokes.channels(), stokes.channel_bytes(), run);
}

/// Returns why a context cannot run compute shaders; empty if it can.
std::string obstacle(const gl::Context& context) {
    constexpr int bindings = 8;
    const gl::Limits& limits = context.limits();
    if (limits.storage_bindings < bindings) {
        return context.info().renderer + " binds " + std::to_string(limits.storage_bindings) +
               " storage buffers at once; " + std::to_string(bindings) + " are needed";
    }
    constexpr std::size_t least = std::size_t{1} << 27;  // the size that OpenGL guarantees
    if (limits.storage_bytes < least) {
        return context.info().renderer + " binds storage buffers of " + std::to_string(limits.storage_bytes) +
               " bytes at most; " + std::to_string(least) + " are needed";
    }
    return {};
}

}  // namespace

const Device kGlDevice{
    .executor = Executor::compute,
    .name = "compute shaders",
    .obstacle = obstacle,
    .preferred = [](const gl::Context& context) { return !context.info().software; },
    .make = [](const std::shared_ptr<gl::Context>& context, VertexBuffers& buffers)
        -> std::unique_ptr<RenderExecutor> { return std::make_unique<GlExecutor>(context, buffers); },
};

GlExecutor::GlExecutor(std::shared_ptr<gl::Context> context, VertexBuffers& buffers)
    : context_(context),
      buffers_(buffers),
      image_(context_),
      textures_(context_),
      factored_(context),
      dense_(context),
      high_orders_(std::move(context)) {}

bool GlExecutor::prepare(const TransferInput& input) {
    buffers_.update(input.geometry, input.versions.geometry, input.channels);
    return !buffers_.empty();
}

std::uint64_t GlExecutor::relight(const FactoredMethod& method, const TransferInput& input,
                                  std::span<const std::uint8_t> /*current*/, RenderRun& run) {
    return context_->run([&]() -> std::uint64_t {
        if (!prepare(input)) return 0;
        factored_.relight(method, input, run.progress, buffers_);
        gl::finish(*context_);
        return input.geometry.positions.size();
    });
}

std::uint64_t GlExecutor::relight(const DenseMethod& method, const TransferInput& input,
                                  std::span<const std::uint8_t> /*current*/, RenderRun& run) {
    return context_->run([&]() -> std::uint64_t {
        if (!prepare(input)) return 0;
        dense_.relight(method, input, run.progress, buffers_);
        gl::finish(*context_);
        return input.geometry.positions.size();
    });
}

DeviceShade& GlExecutor::shade_for(const Viewpoint& view) {
    if (!shade_) shade_.emplace(context_);
    shade_->set_view(view);
    return *shade_;
}

void GlExecutor::shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) {
    run.progress.report("shade", 0);
    context_->run([&] {
        if (prepare(input)) factored_.shade(method, input, shade_for(input.view), vertices(input, false));
    });
}

void GlExecutor::shade(const DenseMethod& /*method*/, const ShadeInput& input, RenderRun& run) {
    run.progress.report("shade", 0);
    context_->run([&] {
        if (prepare(input)) dense_.shade(shade_for(input.view), vertices(input, false));
    });
}

DevicePoints GlExecutor::vertices(const ShadeInput& input, bool fractions) {
    return vertex_points(buffers_, input.geometry, fractions);
}

void GlExecutor::specular(const HighOrderTransfer& high_orders, const ShadeInput& input, RenderRun& /*run*/) {
    context_->run([&] {
        if (!prepare(input)) return;
        high_orders_.compute_fractions(high_orders, input, buffers_);
        const DevicePoints points = vertices(input, !high_orders.visibility()->empty());
        const gl::IndependentDispatches of_ranges(*context_);
        for (const VertexRange& range : input.geometry.ranges)
            high_orders_.add(high_orders, range.material, range.first, range.last, input, points);
    });
}

template <class Method, class Device>
void GlExecutor::shade_pixels_by(const Method& method, Device& device, const PixelInput& input,
                                 RenderRun& run) {
    run.statistics.pixels_shaded += context_->run([&]() -> std::uint64_t {
        image_.resize(input.hits.width(), input.hits.height(), input.channels);
        if (!prepare(input)) {
            image_.clear();
            return 0;
        }
        if (!pixels_) pixels_.emplace(context_, image_);
        DeviceShade& shade = shade_for(input.view);
        if (input.high_orders != nullptr) high_orders_.compute_fractions(*input.high_orders, input, buffers_);
        const std::size_t most = device.prepare_pixels(method, input);
        textures_.prepare(input, buffers_);
        const auto shade_layers = [&](const PixelRun& points) {
            std::size_t layer = 0;
            for (const MaterialPtr& material : plain_materials(points.surface.material)) {
                const DevicePoints& to = textures_.layer_points(pixels_->points());
                device.shade_pixels(material, points, *pixels_, shade, to);
                if (input.high_orders != nullptr)
                    high_orders_.add(*input.high_orders, material, points.first, points.last, input, to);
                textures_.add(layer++, points, pixels_->points());
            }
        };
        const auto shade_plain = [&](std::span<const PixelRun> runs) {
            const DevicePoints& to = pixels_->points();
            {
                const gl::IndependentDispatches of_runs(*context_);
                for (const PixelRun& points : runs)
                    device.shade_pixels(points.surface.material, points, *pixels_, shade, to);
            }
            if (input.high_orders == nullptr) return;
            const gl::IndependentDispatches of_runs(*context_);
            for (const PixelRun& points : runs)
                high_orders_.add(*input.high_orders, points.surface.material, points.first, points.last,
                                 input, to);
        };
        const auto shade_stretch = [&](const PixelStretch& stretch) {
            const PixelRun& first = stretch.runs.front();
            const bool varies = first.surface.material->variation() != nullptr;
            if (varies) textures_.find(input, first, *pixels_);
            device.light_pixels(input, stretch, *pixels_);
            if (varies) {
                shade_layers(first);
            } else {
                shade_plain(stretch.runs);
            }
        };
        const auto finish = [&](std::size_t last) {
            if (!input.light_factors.none()) scale(pixels_->points(), 0, last, input.light_factors);
            if (input.physical) make_physical(pixels_->points(), 0, last, input.noise, uncounted_);
        };
        return pixels_->run(input, buffers_, most, Device::kJoins, run, shade_stretch, finish);
    });
}

void GlExecutor::shade_pixels(const FactoredMethod& method, const PixelInput& input, RenderRun& run) {
    shade_pixels_by(method, factored_, input, run);
}

void GlExecutor::shade_pixels(const DenseMethod& method, const PixelInput& input, RenderRun& run) {
    shade_pixels_by(method, dense_, input, run);
}

void GlExecutor::scale(const ShadeInput& input) {
    context_->run([&] {
        if (prepare(input))
            scale(vertices(input, false), 0, input.geometry.positions.size(), input.light_factors);
    });
}

void GlExecutor::scale(const DevicePoints& points, std::size_t first, std::size_t last,
                       const ChannelFactors& factors) {
    if (!scale_) scale_ = gl::Program::compute(context_, "scale.comp");
    const StokesBuffer& stokes = *points.stokes;
    for (int c = 0; c < stokes.channels(); ++c)
        scale_->set("factors[" + std::to_string(c) + "]", factors.of[static_cast<std::size_t>(c)]);
    run_in_steps(*scale_, stokes, first, last);
}

void GlExecutor::make_physical(const ShadeInput& input) {
    context_->run([&] {
        if (!prepare(input)) return;
        make_physical(vertices(input, false), 0, input.geometry.positions.size(), input.noise, moved_);
        counted_ = true;
    });
}

void GlExecutor::make_physical(const DevicePoints& points, std::size_t first, std::size_t last, float noise,
                               std::optional<gl::Buffer>& counter) {
    if (!counter)
        counter.emplace(context_, gl::BufferUse::storage, sizeof(std::uint32_t), gl::BufferUpdate::fixed);
    if (!physical_) physical_ = gl::Program::compute(context_, "physical.comp");
    physical_->set("noise", noise);
    counter->bind_storage(1);
    run_in_steps(*physical_, *points.stokes, first, last);
}

void GlExecutor::illuminate(const LocalLights& lights, const ShadeInput& input, RenderRun& run) {
    // Threads compute local lights while the device still shades.
    context_->run([&] { gl::flush(*context_); });
    const std::size_t vertices = input.geometry.positions.size();
    VertexStokes sums(static_cast<std::size_t>(input.channels), std::vector<glm::vec4>(vertices));
    const std::vector<std::span<glm::vec4>> channels(sums.begin(), sums.end());
    VertexLights(lights, input).add(run, channels);
    context_->run([&] {
        if (!prepare(input)) return;
        for (int c = 0; c < input.channels; ++c) add(sums[static_cast<std::size_t>(c)], c);
    });
}

void GlExecutor::add(const std::vector<glm::vec4>& more, int channel) {
    if (!add_) add_ = gl::Program::compute(context_, "add.comp");
    const gl::Buffer copy = gl::storage(context_, more);
    for (std::size_t begin = 0; begin < more.size(); begin += kVectorsOfStep) {
        const std::size_t end = std::min(begin + kVectorsOfStep, more.size());
        std::ignore = gl::bind_vertices(copy, 0, 4, begin, end);
        std::ignore = buffers_.stokes().bind(1, {.first = channel, .count = 1}, begin, end);
        add_->set("count", static_cast<int>(end - begin));
        gl::dispatch(*add_, gl::groups_for(end - begin));
    }
}

std::uint64_t GlExecutor::finish() {
    return context_->run([&]() -> std::uint64_t {
        gl::finish(*context_);
        if (!std::exchange(counted_, false)) return 0;
        // The counter is read after the end of all work, so that the read waits for nothing.
        std::uint32_t moved = 0;
        moved_->read(0, std::as_writable_bytes(std::span(&moved, 1)));
        return moved - std::exchange(moved_before_, moved);
    });
}

}  // namespace nicol
