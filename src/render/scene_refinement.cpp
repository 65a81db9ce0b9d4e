// SPDX-License-Identifier: MIT
// Refinement of the surfaces of a bake, and what it takes over from the one before.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "render/bake_inputs.hpp"
#include "render/baked_vertices.hpp"
#include "render/scene_visibility.hpp"
#include "render/shifted_objects.hpp"
#include "visibility/bake_cache.hpp"

namespace nicol {

void SceneVisibility::refine(const SceneGeometry& surfaces, SurfaceRays& rays, const RenderOptions& options,
                             Workers& workers, Progress& progress, Statistics& statistics) {
    const bool shadow_all = (options.disabled_optimisations & skip_unoccluded) != 0;
    const double edge = shortest_edge_;
    refining_.run(baked_.version(), options.refine_tolerance, options.max_vertices, shadow_all, edge, [&] {
        const Stopwatch watch;
        const auto report = [&progress](double fraction) {
            progress.report("bake", kTracingOfBake + (1 - kTracingOfBake) * fraction);
        };
        BakeStatistics baked;
        refined_.reset();
        numbers_ = {};
        topology_ = {};
        std::shared_ptr<const Visibility> visible = *baked_;
        workers.run([&] {
            if (!(options.refine_tolerance > 0)) return;
            std::vector<std::uint8_t> room;
            const std::span traced = traced_of(surfaces.geometry(), needed_, room);
            Refinement refinement = refinement_of(surfaces, geometry_of(surfaces, rays, traced, options),
                                                  *visible, options, report, baked);
            points_ = std::move(refinement.points);
            points_bake_ = baked_.version();
            // A point takes less memory than a vertex, for which the limit leaves room.
            const std::size_t vertices = visible->vertices() + refinement.parents.size();
            if (vertices + points_.size() > options.max_vertices) points_ = {};
            if (refinement.parents.empty()) return;
            RefinedGeometry split = refined(surfaces.geometry(), refinement, options.max_vertices);
            refined_ = std::make_shared<WorldGeometry>(std::move(split.geometry));
            parts_ = std::move(split.parts);
            numbers_ = std::move(split.numbers);
            visible = std::make_shared<const Visibility>(std::move(split.visibility));
            topology_ = std::move(refinement);
            topology_.visibility = {};
        });
        baked_vertices_.clear();
        if (!needed_.empty()) {
            baked_vertices_.assign(visible->vertices(), kTraced);
            for (std::size_t v = 0; v < needed_.size(); ++v) baked_vertices_[numbers_.number(v)] = needed_[v];
        }
        if (shadow_all) {
            Visibility all = *visible;
            for (std::size_t v = 0; v < all.vertices(); ++v) all.set_unoccluded(v, false);
            visible = std::make_shared<const Visibility>(std::move(all));
        }
        visible_.change() = std::move(visible);
        count_bake(baked, watch, statistics);
    });
}

Refinement SceneVisibility::refinement_of(const SceneGeometry& surfaces, const BakeGeometry& geometry,
                                          const Visibility& visible, const RenderOptions& options,
                                          const BakeProgress& report, BakeStatistics& baked) const {
    const RefineOptions wanted{.tolerance = options.refine_tolerance,
                               .max_vertices = options.max_vertices,
                               .shortest_edge = shortest_edge_,
                               .wanted = wanted_};
    FormerRefinement former{.points = points_, .disturbances = {}};
    std::vector<ShiftedObject> shifted;
    if (points_bake_ != baked_.version()) {
        if (points_bake_ == 0 || points_bake_ != carried_) {
            // The cache does not know what vertices saw before a change that they have not followed.
            bool stale = false;
            for (std::size_t v = 0; v < needed_.size() && !stale; ++v)
                stale = needed_[v] == 0 && !visible.unoccluded(v);
            return load_or_refine(geometry, *directions_, visible, wanted,
                                  stale ? std::filesystem::path() : folder_, notice_, report, baked);
        }
        former.disturbances = {surfaces.change().added, surfaces.change().removed};
        shifted = shifted_objects(surfaces.change(), traces_all(options));
        former.shifted = shifted;
    }
    return nicol::refine(geometry, *directions_, visible, wanted, report, baked, &former);
}

}  // namespace nicol
