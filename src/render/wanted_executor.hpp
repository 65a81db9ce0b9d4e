// SPDX-License-Identifier: MIT
// Which executor a scene needs.
#pragma once

#include "scene/scene.hpp"
#include "stage/options.hpp"

namespace nicol {

/// Returns the executor to ask devices for. Threads alone follow rays, so they shade scenes that light
/// passes, and, if users leave the choice open, those whose mirrors or narrow lobes reflect other surfaces.
[[nodiscard]] Executor wanted_executor(const Scene& scene, const RenderOptions& options);

}  // namespace nicol
