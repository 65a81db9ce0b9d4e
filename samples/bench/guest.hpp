// SPDX-License-Identifier: MIT
// A context of Nicol's for all functions.
#pragma once

#include <cstdint>
#include <memory>

#include "common/handles.hpp"
#include "egl_context.hpp"

/// A context on its own thread, or inside the OpenGL of a host on this thread.
struct Guest {
    std::unique_ptr<EglContext> egl;  ///< the host's context; null: none
    std::uint32_t texture = 0;        ///< the host's texture for EntryPoints::host(); 0: none
    Context context;

    /// threads: of nicol_context_options.
    static Guest own(nicol_backend backend, std::uint32_t threads = 0);
    static Guest in_host(std::uint32_t threads = 0);
};
