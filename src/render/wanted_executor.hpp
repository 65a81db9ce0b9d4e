// SPDX-License-Identifier: MIT
// Choice of the executor that a scene needs.
#pragma once

#include "scene/scene.hpp"
#include "stage/options.hpp"

namespace nicol {

/// Returns whether rays may follow narrow lobes: where light bounces and pixels may be shaded.
[[nodiscard]] bool wants_lobes(const RenderOptions& options);

/// Returns the executor to ask devices for. Threads alone follow rays, so they shade scenes that light
/// passes, and, if users leave the choice open, those whose mirrors or narrow lobes reflect other surfaces.
[[nodiscard]] Executor wanted_executor(const Scene& scene, const RenderOptions& options);

}  // namespace nicol
