// SPDX-License-Identifier: MIT
// The available executors, and the choice of one for a render.
#pragma once

#include <memory>
#include <string>

#include "draw/vertex_buffers.hpp"
#include "gl/context.hpp"
#include "methods/executor.hpp"
#include "stage/options.hpp"

namespace nicol {

/// Kind of executor; each folder below devices/ defines one.
struct Device {
    Executor executor;
    const char* name;  ///< name in messages
    /// Returns why a context cannot have the device; empty if it can.
    std::string (*obstacle)(const gl::Context& context);
    /// Returns whether a context that can have the device should, if users leave the choice open.
    bool (*preferred)(const gl::Context& context);
    /// Makes the executor. The vertex buffers must outlive it.
    std::unique_ptr<RenderExecutor> (*make)(const std::shared_ptr<gl::Context>& context,
                                            VertexBuffers& buffers);
};

/// Returns the device for a wanted executor. Throws Error(unsupported) if the context cannot have it.
[[nodiscard]] const Device& device_for(Executor wanted, const gl::Context& context);

}  // namespace nicol
