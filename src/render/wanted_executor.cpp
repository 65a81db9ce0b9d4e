// SPDX-License-Identifier: MIT
#include "render/wanted_executor.hpp"

#include <algorithm>

#include "scene/path_depth.hpp"
#include "surfaces/smooth_surfaces.hpp"

namespace nicol {

bool wants_lobes(const RenderOptions& options) {
    return options.max_depth > kDirectLightDepth && options.shade_at != ShadeAt::vertices;
}

Executor wanted_executor(const Scene& scene, const RenderOptions& options) {
    if (scene.transmits()) return Executor::cpu;
    if (options.executor != Executor::automatic || options.method != Method::factored ||
        options.shade_at == ShadeAt::vertices)
        return options.executor;
    const bool lobes = wants_lobes(options);
    const bool follows = std::ranges::any_of(scene.instances(), [&](const Instance& instance) {
        return smoothness_of(*instance.material, lobes) != Smoothness::none;
    });
    return follows ? Executor::cpu : Executor::automatic;
}

}  // namespace nicol
