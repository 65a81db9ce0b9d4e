// SPDX-License-Identifier: MIT
#include "render/reference_method.hpp"

#include <utility>

#include "progress.hpp"
#include "reference/render_reference.hpp"

namespace nicol {

void render_by_reference(const Scene& scene, const Camera& camera, const RenderOptions& options, int threads,
                         Framebuffer& target) {
    const int width = target.width();
    const int height = target.height();
    ReferenceStatistics traced;
    Aovs aovs;
    StokesImage image = render_reference(scene, project(camera, width, height), width, height,
                                         {.samples = options.samples,
                                          .shadows = options.shadows,
                                          .luminance = target.channels() < scene.channels(),
                                          .seed = options.seed,
                                          .threads = threads,
                                          .aovs = options.aovs,
                                          .progress = options.progress},
                                         traced, Strategy::both, &aovs);
    Statistics statistics;
    for (const Instance& instance : scene.instances()) statistics.vertices += instance.mesh->positions.size();
    statistics.triangles = traced.triangles;
    statistics.bake_ms = traced.build_ms;
    statistics.trace_ms = traced.trace_ms;
    statistics.camera_rays = traced.camera_rays;
    statistics.shadow_rays = traced.shadow_rays;
    const gl::MemoryUse memory = target.context()->memory();
    statistics.texture_bytes = memory.of(gl::MemoryKind::texture) + memory.of(gl::MemoryKind::render_target);
    const Stopwatch watch;
    target.show(std::move(image), statistics, std::move(aovs));
    target.statistics().draw_ms = watch.milliseconds();
}

}  // namespace nicol
