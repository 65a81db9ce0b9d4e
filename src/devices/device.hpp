// SPDX-License-Identifier: MIT
// The executors that there are, and which of them a render gets.
#pragma once

#include <memory>
#include <string>

#include "draw/vertex_buffers.hpp"
#include "gl/context.hpp"
#include "methods/executor.hpp"
#include "stage/options.hpp"

namespace nicol {

/// A folder below devices/ defines one.
struct Device {
    Executor executor;
    const char* name;  ///< as messages have it
    /// Why a context cannot have it; empty where it can.
    std::string (*obstacle)(const gl::Context& context);
    /// Whether a context that can have it should, where users leave the choice.
    bool (*preferred)(const gl::Context& context);
    /// The vertex buffers must outlive the executor.
    std::unique_ptr<RenderExecutor> (*make)(const std::shared_ptr<gl::Context>& context,
                                            VertexBuffers& buffers);
};

/// Throws Error(unsupported) where the context cannot have the device that is wanted.
[[nodiscard]] const Device& device_for(Executor wanted, const gl::Context& context);

}  // namespace nicol
