// SPDX-License-Identifier: MIT
#include "render/gpu/gpu_executor.hpp"

#include <utility>

#include "error.hpp"
#include "gl/draw.hpp"

namespace nicol {
namespace {

[[noreturn]] void refuse_pixels() {
    throw Error(ErrorCode::unsupported,
                "compute shaders do not shade at pixels; shade at vertices, or leave the executor automatic");
}

}  // namespace

std::string GpuExecutor::obstacle(const gl::Context& context) {
    constexpr int bindings = 8;
    const gl::Limits& limits = context.limits();
    if (limits.storage_bindings < bindings) {
        return context.info().renderer + " binds " + std::to_string(limits.storage_bindings) +
               " storage buffers at once; " + std::to_string(bindings) + " are needed";
    }
    constexpr std::size_t least = std::size_t{1} << 27;  // as OpenGL guarantees
    if (limits.storage_bytes < least) {
        return context.info().renderer + " binds storage buffers of " + std::to_string(limits.storage_bytes) +
               " bytes at most; " + std::to_string(least) + " are needed";
    }
    return {};
}

GpuExecutor::GpuExecutor(std::shared_ptr<gl::Context> context, VertexBuffers& buffers,
                         HighOrderTextures& textures)
    : context_(context),
      buffers_(buffers),
      factored_(context),
      dense_(context),
      high_orders_(std::move(context), textures) {}

bool GpuExecutor::prepare(const TransferInput& input) {
    buffers_.update(input.geometry, input.versions.geometry, input.channels);
    return !buffers_.empty();
}

std::uint64_t GpuExecutor::relight(const FactoredMethod& method, const TransferInput& input,
                                   std::span<const std::uint8_t> /*current*/, RenderRun& run) {
    return context_->run([&]() -> std::uint64_t {
        if (!prepare(input)) return 0;
        factored_.relight(method, input, run.progress, buffers_);
        gl::finish(*context_);
        return input.geometry.positions.size();
    });
}

std::uint64_t GpuExecutor::relight(const DenseMethod& method, const TransferInput& input,
                                   std::span<const std::uint8_t> /*current*/, RenderRun& run) {
    return context_->run([&]() -> std::uint64_t {
        if (!prepare(input)) return 0;
        dense_.relight(method, input, run.progress);
        gl::finish(*context_);
        return input.geometry.positions.size();
    });
}

DeviceShade& GpuExecutor::shade_for(const Viewpoint& view) {
    if (!shade_) shade_.emplace(context_);
    shade_->set_view(view);
    return *shade_;
}

void GpuExecutor::shade(const FactoredMethod& method, const ShadeInput& input, RenderRun& run) {
    run.progress.report("shade", 0);
    context_->run([&] {
        if (prepare(input)) factored_.shade(method, input, shade_for(input.view), buffers_);
    });
}

void GpuExecutor::shade(const DenseMethod& /*method*/, const ShadeInput& input, RenderRun& run) {
    run.progress.report("shade", 0);
    context_->run([&] {
        if (prepare(input)) dense_.shade(input, shade_for(input.view), buffers_);
    });
}

void GpuExecutor::specular(const HighOrderTransfer& high_orders, const ShadeInput& input, bool at_pixels,
                           RenderRun& /*run*/) {
    context_->run([&] {
        if (!prepare(input)) return;
        high_orders_.compute_fractions(high_orders, input, buffers_);
        if (!at_pixels) high_orders_.add(high_orders, input, buffers_);
    });
}

void GpuExecutor::shade_pixels(const FactoredMethod& /*method*/, const PixelInput& /*input*/,
                               RenderRun& /*run*/) {
    refuse_pixels();
}

void GpuExecutor::shade_pixels(const DenseMethod& /*method*/, const PixelInput& /*input*/,
                               RenderRun& /*run*/) {
    refuse_pixels();
}

std::uint64_t GpuExecutor::make_physical(const ShadeInput& input) {
    return context_->run([&]() -> std::uint64_t {
        if (!prepare(input)) return 0;
        if (!physical_) physical_ = gl::Program::compute(context_, "physical.comp");
        const std::size_t vertices = input.geometry.positions.size();
        const std::size_t step = std::size_t{1} << 20;
        const gl::Buffer counter(context_, gl::BufferUse::storage, sizeof(std::uint32_t),
                                 gl::BufferUpdate::fixed);
        for (int c = 0; c < input.channels; ++c) {
            for (std::size_t first = 0; first < vertices; first += step) {
                const std::size_t last = std::min(first + step, vertices);
                std::ignore = bind_vertices(*buffers_.stokes(c), 0, 4, first, last);
                counter.bind_storage(1);
                physical_->set("count", static_cast<int>(last - first));
                gl::dispatch(*physical_, groups_for(last - first));
            }
        }
        std::uint32_t moved = 0;
        counter.read(0, std::as_writable_bytes(std::span(&moved, 1)));
        return moved;
    });
}

void GpuExecutor::finish() {
    context_->run([&] { gl::finish(*context_); });
}

}  // namespace nicol
