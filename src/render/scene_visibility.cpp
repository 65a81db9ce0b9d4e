// SPDX-License-Identifier: MIT
#include "render/scene_visibility.hpp"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "visibility/bake_cache.hpp"

namespace nicol {
namespace {

BakeGeometry bake_geometry(const SceneGeometry& surfaces, SurfaceRays& rays) {
    const WorldGeometry& world = surfaces.geometry();
    return {.positions = world.positions,
            .normals = world.normals,
            .triangles = world.triangles,
            .present = presence_of(world),
            .blocking = world.blocking,
            .rays = [&rays] { return rays.get(); }};
}

void count_bake(const BakeStatistics& baked, const Stopwatch& watch, Statistics& statistics) {
    statistics.bake_rays += baked.rays;
    statistics.bake_trace_ms += baked.milliseconds;
    statistics.vertices_traced += baked.vertices;
    statistics.bake_ms += watch.milliseconds();
}

}  // namespace

void SceneVisibility::set_cache(std::filesystem::path folder, CacheNotice notice) {
    folder_ = std::move(folder);
    notice_ = std::move(notice);
}

void SceneVisibility::update(const SceneGeometry& surfaces, SurfaceRays& rays, bool lit,
                             const RenderOptions& options, Workers& workers, Progress& progress,
                             Statistics& statistics) {
    const SurfaceVersions former = versions_;
    const std::shared_ptr<const Visibility> visible_before = *visible_;
    const bool had_bake = former.visibility == visible_.version();
    const bool carried =
        options.shadows && lit && bake(surfaces, rays, options, workers, progress, statistics);
    const bool baked = options.shadows && baked_geometry_ == surfaces.version();
    if (baked) refine(surfaces, rays, options, workers, progress, statistics);
    surfaces_.update(surfaces, baked ? refined_ : nullptr, parts_, numbers_);

    const std::size_t vertices = surfaces_.geometry().positions.size();
    const std::size_t unoccluded = baked ? (*visible_)->unoccluded_count() : vertices;
    const bool shadowed = unoccluded < vertices;
    versions_ = {.geometry = surfaces_.version(), .visibility = shadowed ? visible_.version() : 0};
    statistics.vertices_unoccluded = unoccluded;
    statistics.vertices_added = vertices - surfaces.geometry().positions.size();
    if (baked) {
        statistics.visibility_bytes = (*visible_)->bytes();
        if (*baked_ != *visible_) statistics.visibility_bytes += (*baked_)->bytes();
        statistics.visibility_bytes += points_.bytes();
    }
    if (versions_ == former) return;
    before_.reset();
    if (former.geometry == 0 || former.geometry != surfaces_.change().before) return;
    // All vertices change if shadows appear or disappear.
    if (shadowed ? !(had_bake && carried) : former.visibility != 0) return;
    before_ = former;
    former_ = surfaces_.change().former;
    if (!shadowed) return;
    for (std::size_t v = 0; v < vertices; ++v) {
        const std::uint32_t before = former_[v];
        if (before != kNoVertex && !std::ranges::equal((*visible_)->at(v), visible_before->at(before)))
            former_[v] = kNoVertex;
    }
}

SurfaceState SceneVisibility::state() const {
    const bool shadowed = versions_.visibility != 0;
    std::optional<SurfaceChange> change;
    if (before_) {
        change = {.before = *before_, .former = former_, .same_places = surfaces_.change().same_places};
    }
    return {.geometry = surfaces_.geometry(),
            .visibility = shadowed ? visible_->get() : nullptr,
            .directions = shadowed ? &*directions_ : nullptr,
            .versions = versions_,
            .materials = surfaces_.material_version(),
            .change = change};
}

bool SceneVisibility::bake(const SceneGeometry& surfaces, SurfaceRays& rays, const RenderOptions& options,
                           Workers& workers, Progress& progress, Statistics& statistics) {
    const int count = options.bake_directions;
    const glm::dmat3& axes = surfaces.own_axes();
    const SceneGeometry::Change& change = surfaces.change();
    const bool carry = !change.kept.empty() && baking_.is_current(change.before, count, axes);
    const bool ran = baking_.run(surfaces.version(), count, axes, [&] {
        const Stopwatch watch;
        carried_ = carry ? baked_.version() : 0;
        baked_geometry_ = 0;
        spreading_.run(count, [&] { lattice_.emplace(count); });
        rotating_.run(count, axes, [&] { directions_ = lattice_->rotated(axes); });
        const auto report = [&progress](double fraction) { progress.report("bake", fraction); };
        BakeStatistics baked;
        workers.run([&] {
            const BakeGeometry geometry = bake_geometry(surfaces, rays);
            Visibility visibility;
            if (carry) {
                const FormerBake former{.visibility = **baked_,
                                        .kept = change.kept,
                                        .disturbances = {change.added, change.removed}};
                visibility = nicol::bake(geometry, *directions_, report, &baked, &former);
            } else {
                visibility = load_or_bake(geometry, *directions_, folder_, notice_, report, &baked);
            }
            baked_.change() = std::make_shared<const Visibility>(std::move(visibility));
        });
        baked_geometry_ = surfaces.version();
        count_bake(baked, watch, statistics);
    });
    return ran && carry;
}

void SceneVisibility::refine(const SceneGeometry& surfaces, SurfaceRays& rays, const RenderOptions& options,
                             Workers& workers, Progress& progress, Statistics& statistics) {
    const bool shadow_all = (options.disabled_optimisations & skip_unoccluded) != 0;
    refining_.run(baked_.version(), options.refine_tolerance, options.max_vertices, shadow_all, [&] {
        const Stopwatch watch;
        const auto report = [&progress](double fraction) { progress.report("bake", fraction); };
        BakeStatistics baked;
        refined_.reset();
        std::shared_ptr<const Visibility> visible = *baked_;
        workers.run([&] {
            if (!(options.refine_tolerance > 0)) return;
            Refinement refinement =
                refinement_of(surfaces, bake_geometry(surfaces, rays), *visible, options, report, baked);
            points_ = std::move(refinement.points);
            points_bake_ = baked_.version();
            // A point takes less memory than a vertex, for which the limit leaves room.
            const std::size_t vertices = visible->vertices() + refinement.parents.size();
            if (vertices + points_.size() > options.max_vertices) points_ = {};
            if (refinement.parents.empty()) return;
            RefinedGeometry split = refined(surfaces.geometry(), refinement);
            refined_ = std::make_shared<WorldGeometry>(std::move(split.geometry));
            parts_ = std::move(split.parts);
            numbers_ = std::move(split.numbers);
            visible = std::make_shared<const Visibility>(std::move(split.visibility));
        });
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
    const RefineOptions wanted{.tolerance = options.refine_tolerance, .max_vertices = options.max_vertices};
    FormerRefinement former{.points = points_, .disturbances = {}};
    if (points_bake_ != baked_.version()) {
        if (points_bake_ == 0 || points_bake_ != carried_)
            return load_or_refine(geometry, *directions_, visible, wanted, folder_, notice_, report, baked);
        former.disturbances = {surfaces.change().added, surfaces.change().removed};
    }
    return nicol::refine(geometry, *directions_, visible, wanted, report, baked, &former);
}

}  // namespace nicol
