// SPDX-License-Identifier: MIT
// Bakes of vertices that the bake of a part has left out.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "render/bake_inputs.hpp"
#include "render/baked_vertices.hpp"
#include "render/scene_visibility.hpp"

namespace nicol {

Visibility SceneVisibility::bake_rest(const SceneGeometry& surfaces, BakeGeometry geometry,
                                      const BakeProgress& report, BakeStatistics& baked) const {
    std::vector<std::uint8_t> rest, room;
    for (const std::uint8_t done : needed_) rest.push_back(done == kTraced ? 0 : 1);
    geometry.needed = traced_of(surfaces.geometry(), rest, room);
    geometry.needed_alone = room.empty();  // others than receivers count as unoccluded
    Visibility visibility = nicol::bake(geometry, *directions_, report, &baked);
    for (std::size_t v = 0; v < rest.size(); ++v) {
        if (rest[v] == 0) visibility.take(v, **baked_, v);
    }
    return visibility;
}

bool SceneVisibility::left_out_unsampled() const {
    return !progressive_ && uses_bake_ && versions_.visibility != 0 && seen_.sampled &&
           std::ranges::find(needed_, 0) != needed_.end();
}

void SceneVisibility::bake_shown(const SceneGeometry& surfaces, SurfaceRays& rays,
                                 const std::function<std::span<const std::uint8_t>()>& find_shown, bool lobes,
                                 const RenderOptions& options, RenderRun& run) {
    if (!left_out_unsampled()) return;
    const std::span<const std::uint8_t> shown = find_shown();
    const std::size_t given = needed_.size();
    const WorldGeometry& world = surfaces.geometry();
    std::vector<std::uint8_t> missing(given, 0);
    for (std::uint32_t v = 0; v < shown.size(); ++v) {
        const std::uint32_t i = numbers_.source(v);
        if (shown[v] == 0 || i >= given || needed_[i] != 0) continue;
        if (reflects(*world.ranges[range_of(world, i)].material)) missing[i] = 1;
    }
    if (!any(missing)) return;
    if (shows_others(world, missing, lobes))
        for (std::size_t i = 0; i < given; ++i) missing[i] = needed_[i] == 0 ? 1 : 0;
    std::vector<std::uint32_t> changed;  // vertices of surfaces_
    for (std::uint32_t v = 0; v < shown.size(); ++v) {
        const std::uint32_t i = numbers_.source(v);
        if (i < given && missing[i] != 0) changed.push_back(v);
    }
    const Stopwatch watch;
    const bool shadow_all = (options.disabled_optimisations & skip_unoccluded) != 0;
    BakeStatistics baked;
    run.workers.run([&] {
        std::vector<std::uint8_t> room;
        BakeGeometry geometry = bake_geometry(surfaces, rays, traced_of(world, missing, room), options);
        geometry.needed_alone = room.empty();  // others than receivers count as unoccluded
        const Visibility more = nicol::bake(
            geometry, *directions_, [&run](double fraction) { run.progress.report("bake", fraction); },
            &baked);
        auto all = std::make_shared<Visibility>(**baked_), visible = std::make_shared<Visibility>(**visible_);
        for (std::size_t i = 0; i < given; ++i)
            if (missing[i] != 0) all->take(i, more, i);
        for (const std::uint32_t v : changed) {
            visible->take(v, more, numbers_.source(v));
            if (shadow_all) visible->set_unoccluded(v, false);
        }
        const bool has_points = points_bake_ == baked_.version();
        baked_.change() = std::move(all);
        if (has_points) points_bake_ = baked_.version();
        visible_.change() = std::move(visible);
    });
    for (std::size_t i = 0; i < given; ++i)
        if (missing[i] != 0) needed_[i] = kTraced;
    before_ = versions_;
    former_.resize(shown.size());
    std::iota(former_.begin(), former_.end(), 0U);
    for (const std::uint32_t v : changed) {
        baked_vertices_[v] = kTraced;
        former_[v] = kNoVertex;
    }
    same_places_.assign(shown.size(), 1);
    same_normals_.clear();
    versions_.visibility = visible_.version();
    shown_.show(*visible_);
    // The triangles of these few vertices stay as they are.
    refining_.run(baked_.version(), options.refine_tolerance, options.max_vertices, shadow_all,
                  shortest_edge_, [] {});
    count_bake(baked, watch, run.statistics);
}

}  // namespace nicol
