// SPDX-License-Identifier: MIT
#include "render/gpu/compute_executor.hpp"

#include <utility>

#include "gl/draw.hpp"

namespace nicol {

std::string ComputeExecutor::obstacle(const gl::Context& context) {
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

ComputeExecutor::ComputeExecutor(std::shared_ptr<gl::Context> context, VertexBuffers& buffers,
                                 HighOrderTextures& textures)
    : context_(context),
      buffers_(buffers),
      factored_(context),
      dense_(context),
      high_orders_(std::move(context), textures) {}

void ComputeExecutor::run(FactoredMethod& method, const Extras& extras, const TransferInput& input,
                          const DistantLight& light, const Viewpoint& view, Progress& progress,
                          Statistics& statistics) {
    run_on(factored_, method, extras, input, light, view, progress, statistics);
}

void ComputeExecutor::run(DenseMethod& method, const Extras& extras, const TransferInput& input,
                          const DistantLight& light, const Viewpoint& view, Progress& progress,
                          Statistics& statistics) {
    run_on(dense_, method, extras, input, light, view, progress, statistics);
}

template <class Device, class Method>
void ComputeExecutor::run_on(Device& device, Method& method, const Extras& extras, const TransferInput& input,
                             const DistantLight& light, const Viewpoint& view, Progress& progress,
                             Statistics& statistics) {
    context_->run([&] {
        buffers_.update(input.geometry, input.geometry_revision, input.channels);
        if (buffers_.empty()) return;
        device.relight(method, input, progress, statistics, buffers_);
        const Stopwatch watch;
        progress.report("shade", 0);
        if (!shade_) shade_.emplace(context_);
        shade_->set_view(view);
        device.shade(input, *shade_, buffers_);
        if (extras.high_orders != nullptr) {
            high_orders_.see(*extras.high_orders, input, view, buffers_);
            if (!extras.at_pixels) high_orders_.shade(*extras.high_orders, input, light, view, buffers_);
        }
        if (extras.physical) statistics.vertices_unphysical += make_physical(input);
        gl::finish(*context_);
        statistics.vertices_shaded += input.geometry.positions.size();
        statistics.shade_ms += watch.milliseconds();
    });
    statistics.compute = true;
}

std::uint64_t ComputeExecutor::make_physical(const TransferInput& input) {
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
}

}  // namespace nicol
