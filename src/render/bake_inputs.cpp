// SPDX-License-Identifier: MIT
#include "render/bake_inputs.hpp"

#include <cstddef>

namespace nicol {

std::span<const std::uint8_t> traced_of(const WorldGeometry& geometry, std::span<const std::uint8_t> needed,
                                        std::vector<std::uint8_t>& room) {
    const std::vector<std::uint8_t> shadowed = receivers_of(geometry);
    if (shadowed.empty()) return needed;
    room = shadowed;
    for (std::size_t v = 0; v < needed.size(); ++v)
        if (needed[v] == 0) room[v] = 0;
    return room;
}

BakeGeometry bake_geometry(const SceneGeometry& surfaces, SurfaceRays& rays,
                           std::span<const std::uint8_t> needed, const RenderOptions& options) {
    const WorldGeometry& world = surfaces.geometry();
    return {.positions = world.positions,
            .normals = world.normals,
            .triangles = world.triangles,
            .present = presence_of(world),
            .blocking = world.blocking,
            .glass = rays.glass(),
            .rays = [&rays] { return rays.get(); },
            .needed = needed,
            .every_ray = (options.disabled_optimisations & skip_rays) != 0};
}

void count_bake(const BakeStatistics& baked, const Stopwatch& watch, Statistics& statistics) {
    statistics.bake_rays += baked.rays;
    statistics.bake_rays_skipped += baked.rays_skipped;
    statistics.bake_trace_ms += baked.milliseconds;
    statistics.vertices_traced += baked.vertices;
    statistics.bake_ms += watch.milliseconds();
}

}  // namespace nicol
